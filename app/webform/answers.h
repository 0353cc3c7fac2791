// Answer files: what persons answered on the form as a web page (`NAME.tactus-answers.json`, docs/study-form.md), and
// how they come into a study.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/webform/web_form.h"
#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/record_id.h"
#include "core/study/records.h"

namespace tactus::webform {

/// The answer to one item, or to one sentence about the simulator.
struct FileAnswer {
  int item = 0;
  std::string term;  ///< empty unless answered
  study::Answer::Status status = study::Answer::Status::kSkipped;
  std::int64_t utc_ms = 0;  ///< when it was given; of an item never seen, when the form was finished
  int changes = 0;          ///< how often another answer took its place
  double response_s = 0;    ///< from the display of the question
};

/// A stored answer about the person: `handedness`, `left`. Empty: the person did not say.
struct FileProfile {
  std::string field;
  std::string value;
};

struct AnswerFile {
  study::RecordId study;
  std::string form, wording, form_sha256, language;
  std::string code;         ///< of the participant
  bool code_typed = false;  ///< the researcher gave the code; otherwise the page drew it
  study::RecordId run;      ///< the person's way through the page: the same in every file saved from it
  std::string consent_version, consent_time, consent_language, consent_text;
  std::int64_t consent_utc_ms = 0;
  std::vector<FileProfile> profile;  ///< in the order of the file
  std::vector<FileAnswer> answers;
  std::vector<FileAnswer> usability;  ///< what a clinical teacher thinks of the simulator; may be empty
  std::string check_code;
};

/// Reads the text of an answer file; `file`: its name in errors. Unknown members are ignored.
base::Result<AnswerFile> parseAnswerFile(std::string_view text, const std::string& file);

/// The check code of what the file holds, such as `7QK2-M4XD`.
std::string checkCodeOf(const AnswerFile& answers);

/// Refuses, with one sentence about `file`, answers that were not given to one of `forms` as it was given out: another
/// study or form, a consent of another version, unknown or missing items, terms that the form does not offer, a check
/// code that does not fit. Returns the form that was answered.
base::Result<const FormContent*> formAnswered(const AnswerFile& answers, std::span<const FormContent> forms,
                                              const std::string& file);

// Answer files into a study file.

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
/// simulator. The log of the session has the hash of the file and the check code. All ids follow from the study and the
/// file, so a file that is read twice changes nothing, also after a merge. Answers that were saved again after a change
/// are a further session, which counts. Refused: what `formAnswered` refuses, a code that the page drew and another
/// participant has, a participant who is simulated or withdrew.
base::Result<AnswerImport> importAnswers(store::StudyFile& file, const std::vector<std::string>& paths,
                                         std::int64_t utc_ms);

}  // namespace tactus::webform
