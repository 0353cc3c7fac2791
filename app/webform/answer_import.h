// Answer files of the form as a web page into a study file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/store/study_file.h"

namespace tactus::webform {

/// What became of one file.
struct ImportedAnswers {
  std::string path;
  std::string participant;  ///< code
  bool added = false;       ///< false: all of it was in the study already
  std::size_t answered = 0;
};

struct AnswerImport {
  std::vector<ImportedAnswers> files;  ///< in the order of the paths
  std::size_t persons = 0;             ///< new ones
  std::size_t sessions = 0;
  std::size_t records = 0;
  std::vector<std::string> notes;  ///< one sentence each
};

/// Adds the answers in `paths` to `file`, all or nothing. Each person gets a session of the kind `import` with consent,
/// profile and answers at the times when they were given, and one of the kind `usability` for what was said of the
/// simulator. The log names the file, its hash and the check code. All ids follow from the study and the file, so a
/// file that is read twice changes nothing, also after a merge. Answers that were saved again after a change are a
/// further session, which counts. Refused: what `formAnswered` refuses, a code that the page drew and another
/// participant has, a participant who is simulated or withdrew.
base::Result<AnswerImport> importAnswers(store::StudyFile& file, const std::vector<std::string>& paths,
                                         std::int64_t utc_ms);

}  // namespace tactus::webform
