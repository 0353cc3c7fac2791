#include "app/session/study_aside.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "core/store/study_records.h"
#include "core/store/entries.h"

namespace tactus::session {

base::Result<StudyAside> asideOf(const store::StudyFile& file) {
  StudyAside out;
  const auto measured = store::depthMeasurement(file);
  if (!measured) return tl::unexpected(measured.error());
  if (*measured) {
    auto depths = elicitation::readMeasurement((*measured)->text);
    if (!depths) return tl::unexpected(depths.error());
    out.measured_depths = std::move(*depths);
  }
  const auto answers = store::answers(file);
  if (!answers) return tl::unexpected(answers.error());
  auto rows = questionnaires::summarize(questionnaires::usabilityForm(), *answers);
  if (std::any_of(rows.begin(), rows.end(), [](const auto& row) { return row.n > 0; })) out.usability = std::move(rows);
  return out;
}

base::Result<StudyAside> readAside(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return StudyAside{};
  const auto file = store::StudyFile::open(path, {store::Access::kReadOnly, {}});
  if (!file) return tl::unexpected(file.error());
  return asideOf(*file);
}

}  // namespace tactus::session
