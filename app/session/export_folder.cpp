#include "app/session/export_folder.h"

#include <algorithm>
#include <set>
#include <utility>

#include "app/session/codebook.h"
#include "core/base/file.h"
#include "core/study/record_id.h"
#include "core/study/table_line.h"

namespace tactus::session {
namespace {

namespace fs = std::filesystem;
using base::Error;
using base::ErrorCode;
using base::Result;

/// What an export puts into its folder, besides recordings and models.
const std::set<std::string>& knownFiles() {
  static const std::set<std::string> files = [] {
    std::set<std::string> names = {"codebook.json", "codebook.md"};
    for (const auto table : {study::kParticipantsTable, study::kSpeedsTable, study::kJudgementsTable,
                             study::kAnswersTable, study::kRulesTable}) {
      names.emplace(table);
    }
    for (const auto& table : store::recordTables()) names.insert("records/" + std::string(table.file));
    return names;
  }();
  return files;
}

bool isOurs(const fs::path& path) {
  const std::string below = path.parent_path().generic_string();
  if (below == "records/recordings" || below == "records/models") {
    return study::parseRecordId(path.stem().string()).has_value();
  }
  return knownFiles().contains(path.generic_string());
}

Error notFree(const fs::path& folder, std::string found) {
  return {ErrorCode::kIo, folder.string(), {}, std::move(found), "a new or empty folder, or one that an export made"};
}

/// An earlier export has its codebook, and nothing of anybody else.
Result<void> requireFree(const fs::path& folder) {
  std::error_code error;
  if (!fs::exists(folder, error)) return {};
  if (!fs::is_directory(folder, error)) return tl::unexpected(notFree(folder, "a file"));
  if (fs::is_empty(folder, error)) return {};
  const auto codebook = base::readFile((folder / "codebook.json").string(), std::size_t{1} << 24U);
  if (!codebook || codebook->find(kCodebookFormat) == std::string::npos) {
    return tl::unexpected(notFree(folder, "a folder that holds other files"));
  }
  for (const auto& entry : fs::recursive_directory_iterator(folder, error)) {
    const fs::path below = entry.path().lexically_relative(folder);
    if (!entry.is_directory() && !isOurs(below)) {
      return tl::unexpected(notFree(folder, "an earlier export with another file, " + base::quoted(below.string())));
    }
  }
  return {};
}

/// A name beside `path` that is free.
fs::path freeName(const fs::path& path, const std::string& ending) {
  std::error_code ignored;
  for (int number = 1;; ++number) {
    fs::path name = path;
    name += ending + std::to_string(number);
    if (!fs::exists(name, ignored)) return name;
  }
}

tl::unexpected<Error> ioError(const fs::path& path, const std::error_code& error) {
  return tl::unexpected(Error{ErrorCode::kIo, path.string(), {}, error.message(), "a folder that can be written"});
}

}  // namespace

ExportFolder::ExportFolder(fs::path target, fs::path temporary)
    : target_(std::move(target)), temporary_(std::move(temporary)) {}
ExportFolder::ExportFolder(ExportFolder&& other) noexcept
    : target_(std::exchange(other.target_, {})), temporary_(std::exchange(other.temporary_, {})) {}
ExportFolder::~ExportFolder() {
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove_all(temporary_, ignored);
}

Result<ExportFolder> ExportFolder::beside(const std::string& folder) {
  std::error_code error;
  fs::path target = fs::weakly_canonical(fs::absolute(folder, error), error);
  if (error) return ioError(folder, error);
  if (!target.has_filename()) target = target.parent_path();
  if (auto free = requireFree(target); !free) return tl::unexpected(free.error());
  if (auto made = base::makeFolder(target.parent_path().string()); !made) return tl::unexpected(made.error());
  fs::path temporary = freeName(target, ".new-");
  if (!fs::create_directory(temporary, error)) return ioError(temporary, error);
  return ExportFolder(std::move(target), std::move(temporary));
}

Result<void> ExportFolder::place() {
  std::error_code error;
  fs::path old;
  if (fs::exists(target_, error)) {
    old = freeName(target_, ".old-");
    fs::rename(target_, old, error);
    if (error) return ioError(target_, error);
  }
  fs::rename(temporary_, target_, error);
  if (error) {
    const auto failed = ioError(target_, error);
    if (!old.empty()) fs::rename(old, target_, error);
    return failed;
  }
  temporary_.clear();
  if (!old.empty()) fs::remove_all(old, error);
  return {};
}

}  // namespace tactus::session
