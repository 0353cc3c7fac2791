#include "app/session/study_source.h"

#include <filesystem>
#include <utility>

#include "app/session/study_view.h"
#include "app/session/table_words.h"
#include "core/store/study_file.h"

namespace tactus::session {

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
  const auto file = store::StudyFile::open(path, {store::Access::kReadOnly, {}});
  if (!file) return tl::unexpected(file.error());
  auto view = studyForElicitation(*file);
  if (!view) return tl::unexpected(view.error());
  study::StudyTables tables{std::move(view->study), std::move(view->notes)};
  for (const auto& notice : file->notices()) tables.notices.push_back(notice.sentence);
  return tables;
}

}  // namespace tactus::session
