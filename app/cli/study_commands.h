// The subcommands of `tactus study`: work on study files (docs/study-file.md).
#pragma once

#include <string>
#include <vector>

#include "app/cli/commands.h"

namespace tactus::cli {

struct StudyNewOptions {
  std::string file;
  std::string name;  ///< empty: the file's name
};
/// Makes a study file without participants.
base::Result<Output> studyNew(const StudyNewOptions& options);

struct StudyInfoOptions {
  std::string file;
  bool json = false;
};
/// What the file holds.
base::Result<Output> studyInfo(const StudyInfoOptions& options);

struct StudyCheckOptions {
  std::string file;  ///< a study file, or a folder with the CSV tables
  bool json = false;
};
/// Looks for lost and contradicting records, and at the data (session::dataFindings). Findings are results; what cannot
/// be read is an error.
base::Result<Output> studyCheck(const StudyCheckOptions& options);

struct StudyMergeOptions {
  std::string file;
  std::vector<std::string> others;
  bool json = false;
};
/// Adds the records of other files, one file after the other.
base::Result<Output> studyMerge(const StudyMergeOptions& options);

struct StudyImportOptions {
  std::string file;  ///< is made where it is not there
  std::string folder;
  std::vector<std::string> accept;  ///< kinds of findings that do not stop the import (accepted_data.h)
  bool json = false;
};
/// Adds the CSV tables of a folder, or a full export.
base::Result<Output> studyImport(const StudyImportOptions& options);

struct StudyExportOptions {
  std::string file;
  std::string folder;
  bool shareable = false;
  bool mark = false;  ///< a byte order mark in each CSV table
  bool json = false;
};
/// Writes CSV tables with a codebook.
base::Result<Output> studyExport(const StudyExportOptions& options);

struct StudyRecodeOptions {
  std::string file;
  std::string person;  ///< code or id
  std::string code;    ///< the new one
};
/// Gives a participant another code.
base::Result<Output> studyRecode(const StudyRecodeOptions& options);

struct StudyWithdrawOptions {
  std::string file;
  std::string person;  ///< code or id
};
/// Removes everything of a participant for good. Of one who withdrew already, only what an interrupted erasure left.
base::Result<Output> studyWithdraw(const StudyWithdrawOptions& options);

struct StudyEraseOptions {
  std::string file;
};
/// Finishes an erasure that was interrupted.
base::Result<Output> studyErase(const StudyEraseOptions& options);

}  // namespace tactus::cli
