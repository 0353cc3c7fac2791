#include "app/session/study_source.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/session/study_view.h"
#include "app/session/table_words.h"
#include "core/base/error.h"
#include "core/store/entries.h"
#include "core/store/study_file.h"
#include "core/store/study_records.h"
#include "questionnaires/form_file.h"
#include "questionnaires/published_rules.h"

namespace tactus::session {

base::Result<StudyAside> asideOf(const store::StudyFile& file) {
  StudyAside out;
  TACTUS_TRY(const auto measured, store::depthMeasurement(file));
  if (measured) {
    TACTUS_TRY(auto depths, elicitation::readMeasurement((measured)->text));
    out.measured_depths = std::move(depths);
  }
  TACTUS_TRY(const auto answers, store::answers(file));
  auto rows = questionnaires::summarize(questionnaires::usabilityForm(), answers);
  if (std::any_of(rows.begin(), rows.end(), [](const auto& row) { return row.n > 0; })) out.usability = std::move(rows);
  return out;
}

base::Result<StudyAside> readAside(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return StudyAside{};
  TACTUS_TRY(const auto file, store::StudyFile::open(path, {store::Access::kReadOnly, {}}));
  return asideOf(file);
}

std::vector<study::Form> knownForms() {
  std::vector<study::Form> forms = {questionnaires::ngtForceForm()};
  for (const auto& reading : questionnaires::s4Readings()) {
    study::Form form;
    form.id = reading.id;
    form.title = reading.title;
    form.depth_terms = reading.depth_terms;
    forms.push_back(std::move(form));
  }
  return forms;
}

base::Result<study::StudyTables> readTables(const std::string& folder, const std::vector<std::string>& input_ids) {
  auto tables = study::readStudyFolder(folder, input_ids);
  if (!tables) return tables;
  auto notes = readWords(tables->study);
  tables->notes.insert(tables->notes.end(), notes.begin(), notes.end());
  return tables;
}

base::Result<study::StudyTables> readStudy(const std::string& path, const std::vector<std::string>& input_ids) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (std::filesystem::is_directory(status)) return readTables(path, input_ids);
  if (!std::filesystem::is_regular_file(status)) {
    const bool is_there = std::filesystem::exists(status);
    return tl::unexpected(base::Error{base::ErrorCode::kIo,
                                      path,
                                      {},
                                      is_there ? "a device or a pipe" : "nothing of this name",
                                      "a study file, or a folder with participants.csv"});
  }
  TACTUS_TRY(const auto file, store::StudyFile::open(path, {store::Access::kReadOnly, {}}));
  TACTUS_TRY(auto view, studyForElicitation(file));
  study::StudyTables tables{std::move(view.study), std::move(view.notes)};
  for (const auto& notice : file.notices()) tables.notices.push_back(notice.sentence);
  return tables;
}

}  // namespace tactus::session
