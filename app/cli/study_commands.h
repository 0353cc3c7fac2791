// The subcommands of `tactus study`: work on study files (docs/study-file.md).
#pragma once

#include <string>
#include <vector>

#include "app/cli/commands.h"

namespace tactus::cli {

struct StudyNewOptions {
  std::string file;
  std::string name;  ///< empty: the file's name
  bool json = false;
};
/// Creates a study file without participants.
base::Result<Output> studyNew(const StudyNewOptions& options);

struct StudyInfoOptions {
  std::string file;
  bool json = false;
};
/// Prints the contents of the file.
base::Result<Output> studyInfo(const StudyInfoOptions& options);

struct StudyCheckOptions {
  std::string file;  ///< a study file or a folder of CSV tables
  bool json = false;
};
/// Checks for lost and contradicting records, and checks the data (session::dataFindings). Findings are results; an
/// unreadable file is an error.
base::Result<Output> studyCheck(const StudyCheckOptions& options);

struct StudyMergeOptions {
  std::string file;
  std::vector<std::string> others;
  bool json = false;
};
/// Adds the records of other files, one file after another.
base::Result<Output> studyMerge(const StudyMergeOptions& options);

struct StudyImportOptions {
  std::string file;  ///< created if it does not exist
  std::string folder;
  std::vector<std::string> accept;  ///< kinds of findings that do not stop the import (accepted_data.h)
  bool json = false;
};
/// Imports the CSV tables of a folder, or a full export.
base::Result<Output> studyImport(const StudyImportOptions& options);

struct StudyExportOptions {
  std::string file;
  std::string folder;
  bool shareable = false;
  bool mark = false;   ///< writes a byte order mark into each CSV table
  std::string layout;  ///< `psych-ds`, `bids`; empty: the program's own tables
  bool json = false;
};
/// Exports CSV tables with a codebook; with `layout` a data set for publication, of a study file or a folder of tables.
base::Result<Output> studyExport(const StudyExportOptions& options);

struct StudyFormOptions {
  std::string study;                 ///< a study file, or a folder with CSV tables, which has no protocol
  std::string to;                    ///< `redcap`, `limesurvey`, `print`; empty: `responses` are read
  std::string out;                   ///< folder
  std::string wording;               ///< `plain` or `published`; empty: the form's usual one, of responses not known
  std::string responses;             ///< CSV table that a survey system exported
  std::string participants;          ///< CSV table `record,participant`; empty: the record ids are the codes
  std::vector<std::string> missing;  ///< cells of the responses that mean no answer
  bool json = false;
};
/// Writes the form that the study's participants answer, in the languages of its protocol, for people who answer it
/// elsewhere; or with `responses` reads their answers.
base::Result<Output> studyForm(const StudyFormOptions& options);

/// The responses of `studyForm` as the tables of a study, in the folder `out`. `form`: the study's; `notices` of its
/// opening.
base::Result<Output> studyResponses(const StudyFormOptions& options, const std::string& form,
                                    std::vector<std::string> notices);

struct StudyRecodeOptions {
  std::string file;
  std::string person;  ///< code or id
  std::string code;    ///< the new code
};
/// Gives a participant another code.
base::Result<Output> studyRecode(const StudyRecodeOptions& options);

struct StudyWithdrawOptions {
  std::string file;
  std::string person;  ///< code or id
  bool yes = false;    ///< really remove
  bool dry_run = false;
  bool json = false;
};
/// Removes all data of a participant permanently; with `dry_run` only says what would be removed and what would stay.
/// For a participant who withdrew already, removes the rest of an interrupted erasure.
base::Result<Output> studyWithdraw(const StudyWithdrawOptions& options);

struct StudyProtocolOptions {
  std::string file;
  std::vector<std::string> set;      ///< `NAME=VALUE` (session/protocol_values.h)
  std::vector<std::string> consent;  ///< `LANGUAGE=FILE`, the text in that language
  std::string from;                  ///< a protocol as JSON to begin with; empty: the study's own
  std::string reason;                ///< of an amendment
  std::string author;
  bool json = false;
};
/// Prints the protocol of the study. With `set`, `consent` or `from` stores another one first: a draft, or, once
/// participants follow the present version, its amendment.
base::Result<Output> studyProtocol(const StudyProtocolOptions& options);

struct StudyKeyOptions {
  std::string file;
  std::string from;  ///< file whose first line is the key; empty: the first line of the standard input
  bool remove = false;
};
/// Sets or removes the research key.
base::Result<Output> studyKey(const StudyKeyOptions& options);

struct StudyEraseOptions {
  std::string file;
  bool json = false;
};
/// Finishes an interrupted erasure.
base::Result<Output> studyErase(const StudyEraseOptions& options);

/// The options of `build` for the model that the others are compared with; `out` is not used.
struct StudyCompareOptions : BuildOptions {};
/// The averaged model under other choices of the method, one at a time, in newtons and just-noticeable differences.
base::Result<Output> studyCompare(const StudyCompareOptions& options);

}  // namespace tactus::cli
