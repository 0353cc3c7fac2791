// The commands `tactus study` and `tactus pack`: plain functions from options to output.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/commands.h"
#include "app/session/simulated_study.h"
#include "app/session/study_procedure.h"
#include "core/base/error.h"

namespace tactus::cli {

struct StudyNewOptions {
  std::string file;
  std::string name;  ///< empty: the file's name
  std::string pack;  ///< folder of a pack, or a procedure that the program carries; empty: the default one
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

struct StudySimulateOptions {
  std::string file;
  session::SimulatedGroup group;
  bool json = false;
};
/// Adds simulated experts to a study, each with a whole session under its protocol, to try the study before anybody is
/// asked. They are marked as simulated everywhere.
base::Result<Output> studySimulate(const StudySimulateOptions& options);

struct StudyImportOptions {
  std::string file;  ///< created if it does not exist
  /// One folder, or answer files of the form as a web page (app/webform), any number.
  std::vector<std::string> sources;
  std::vector<std::string> accept;  ///< kinds of findings that do not stop the import (study_build.h)
  bool json = false;
};
/// Imports the CSV tables of a folder, a full export, or answer files.
base::Result<Output> studyImport(const StudyImportOptions& options);

/// The part of `studyImport` for answer files: adds them to a study file, all or none.
base::Result<Output> studyAnswers(const StudyImportOptions& options);

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
  std::string to;                    ///< `web`, `redcap`, `limesurvey`, `print`; empty: `responses` are read
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
  std::vector<std::string> set;      ///< `NAME=VALUE` (session/study_protocol.h)
  std::vector<std::string> consent;  ///< `LANGUAGE=FILE`, the text in that language
  std::string from;                  ///< a protocol as JSON to begin with; empty: the study's own
  std::string preset;                ///< settings to begin with (session::protocolPresets); empty: none
  std::string reason;                ///< of an amendment
  std::string author;
  bool json = false;
};
/// Prints the protocol of the study. With `set`, `consent`, `preset` or `from` stores another one first: a draft, or,
/// once participants follow the present version, its amendment.
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

/// The options of `build`; `out` is a CSV file for the bands, or empty. `replicates` 0: no band that needs draws.
struct StudyBandsOptions : BuildOptions {
  std::vector<std::string> at;  ///< `INPUT=VALUE`, inputs of the curve other than its usual ones
};
/// The bands around the averaged force along the depth, and how far the participants disagree through their words and
/// their rules (elicitation/uncertainty).
base::Result<Output> studyBands(const StudyBandsOptions& options);

struct StudyPlanOptions {
  std::string study;  ///< a running study, as a file or a folder; empty: a study to come
  std::string pack;   ///< procedure of a study to come; empty: the default procedure
  double precision_n = 0.1;
  std::string region;  ///< id of a depth term; empty: all regions
  int most_nurses = 12;
  std::vector<int>
      questions;             ///< empty: a third, two thirds and all; of a running study ten fewer, as many and ten more
  std::vector<int> strokes;  ///< at each speed; empty: 4; of a running study as it has
  std::vector<double> minutes;  ///< of the rest, a stroke, a force, a question; empty: those of planning::PartMinutes
  std::size_t studies = 200;
  std::uint64_t seed = 1;
  elicitation::ForceTermsFrom force_terms = elicitation::ForceTermsFrom::kVote;
  std::string out;  ///< CSV file of the designs, or empty
  bool json = false;
};
/// The error of the averaged force against nurses and questions, by simulated studies (app/planning), and the cheapest
/// design.
base::Result<Output> studyPlan(const StudyPlanOptions& options);

struct StudyTrialOptions {
  std::string pack;  ///< procedure; empty: the default procedure
  int nurses = 4;
  int strokes = 4;  ///< at each speed
  std::size_t studies = 500;
  std::uint64_t seed = 1;
  elicitation::ForceTermsFrom force_terms = elicitation::ForceTermsFrom::kVote;
  bool json = false;
};
/// How often a truth that only the simulation knows lies in the stated band (app/planning/band_trial.h).
base::Result<Output> studyTrial(const StudyTrialOptions& options);

// Procedures as data (docs/procedure-packs.md).

/// The procedure `pack`: one that the program carries, or a pack in a folder or a zip file.
base::Result<session::ProcedurePtr> packNamed(const std::string& pack);

struct PackOptions {
  std::string pack;    ///< folder, or the id of a pack that the program carries; empty: all that it carries
  std::string out;     ///< of `preview`: the folder to write
  bool texts = false;  ///< of `show`: the ids of the participant's screens with their words
  bool json = false;
};

/// Writes a small complete pack into the new folder `pack`.
base::Result<Output> packNew(const PackOptions& options);
/// What is wrong with a pack, or what it holds.
base::Result<Output> packCheck(const PackOptions& options);
/// Inputs, words, regions and items of a pack.
base::Result<Output> packShow(const PackOptions& options);
/// Each form as a page on paper, and the picture with each region lit.
base::Result<Output> packPreview(const PackOptions& options);

}  // namespace tactus::cli
