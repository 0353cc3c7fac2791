#include "app/session/export_folder.h"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <optional>
#include <set>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "app/session/codebook.h"
#include "core/base/files/file.h"
#include "core/base/files/unfinished.h"
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

/// The first file of the folder that no export makes, or nothing.
std::optional<fs::path> otherFile(const fs::path& folder, const ExportKind& kind) {
  std::error_code error;
  for (const auto& entry : fs::recursive_directory_iterator(folder, error)) {
    const fs::path below = entry.path().lexically_relative(folder);
    if (!entry.is_directory(error) && !kind.is_ours(below)) return below;
  }
  return std::nullopt;
}

/// An earlier export has its marker, and no file that an export does not write.
Result<void> requireFree(const fs::path& folder, const ExportKind& kind) {
  std::error_code error;
  if (!fs::exists(folder, error)) return {};
  if (!fs::is_directory(folder, error)) return tl::unexpected(notFree(folder, "a file"));
  if (fs::is_empty(folder, error)) return {};
  const auto marker = base::readFile((folder / kind.marker).string(), std::size_t{1} << 24U);
  if (!marker || marker->find(kind.text) == std::string::npos) {
    return tl::unexpected(notFree(folder, "a folder that holds other files"));
  }
  if (const auto other = otherFile(folder, kind)) {
    return tl::unexpected(notFree(folder, "an earlier export with another file, " + base::quoted(other->string())));
  }
  return {};
}

tl::unexpected<Error> ioError(const fs::path& path, const std::error_code& error) {
  return tl::unexpected(Error{ErrorCode::kIo, path.string(), {}, error.message(), "a folder that can be written"});
}

/// Gives the new folder `from` the name `to`, which an older folder has; that gets the name of the new one.
Result<void> exchange(const fs::path& from, const fs::path& to, Swap swap) {
  const base::Exchange no_stop_between;
  if (swap == Swap::kAtOnce) {
    if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_EXCHANGE) == 0) return {};
    const bool is_unknown = errno == EINVAL || errno == ENOSYS || errno == ENOTSUP;
    if (!is_unknown) return ioError(to, {errno, std::generic_category()});
  }
  // The file system cannot exchange names. After a crash between the two steps both folders are still there.
  std::error_code error;
  auto old = base::makeUnfinishedFolder(to.string(), base::kUnfinishedEnding);
  if (!old.descriptor.isOpen()) return ioError(to, {errno, std::generic_category()});
  fs::rename(to, old.path, error);
  if (error) {
    fs::remove(old.path);
    return ioError(to, error);
  }
  fs::rename(from, to, error);
  if (error) {
    const auto failed = ioError(to, error);
    fs::rename(old.path, to, error);
    return failed;
  }
  fs::rename(old.path, from, error);
  return {};
}

}  // namespace

ExportKind tablesExport() { return {"codebook.json", kCodebookFormat, isOurs}; }

bool isExport(const fs::path& folder) {
  std::error_code error;
  return fs::is_directory(folder, error) && !fs::is_empty(folder, error) && !otherFile(folder, tablesExport());
}

ExportFolder::ExportFolder(fs::path target, fs::path temporary, base::Descriptor in_use)
    : target_(std::move(target)), temporary_(std::move(temporary)), in_use_(std::move(in_use)) {}
ExportFolder::ExportFolder(ExportFolder&& other) noexcept
    : target_(std::exchange(other.target_, {})),
      temporary_(std::exchange(other.temporary_, {})),
      in_use_(std::move(other.in_use_)) {}
ExportFolder::~ExportFolder() {
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove_all(temporary_, ignored);
}

Result<ExportFolder> ExportFolder::beside(const std::string& folder, const ExportKind& kind) {
  std::error_code error;
  fs::path target = fs::weakly_canonical(fs::absolute(folder, error), error);
  if (error) return ioError(folder, error);
  if (!target.has_filename()) target = target.parent_path();
  if (auto free = requireFree(target, kind); !free) {
    free.error().file = folder;  // as the caller named it
    return tl::unexpected(free.error());
  }
  if (auto made = base::makeFolder(target.parent_path().string()); !made) return tl::unexpected(made.error());
  auto [temporary, in_use] = base::makeUnfinishedFolder(target.string(), base::kUnfinishedEnding);
  if (!in_use.isOpen()) return ioError(target.parent_path(), {errno, std::generic_category()});
  return ExportFolder(std::move(target), std::move(temporary), std::move(in_use));
}

Result<void> ExportFolder::place(Swap swap) {
  std::error_code error;
  const auto old = fs::status(target_, error);
  if (fs::exists(old)) {
    fs::permissions(temporary_, old.permissions(), error);
    if (error) return ioError(target_, error);
    if (auto exchanged = exchange(temporary_, target_, swap); !exchanged) return exchanged;
    fs::remove_all(temporary_, error);
  } else {
    fs::rename(temporary_, target_, error);
    if (error) return ioError(target_, error);
  }
  temporary_.clear();
  const base::Descriptor parent(::open(target_.parent_path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!parent.isOpen() || ::fsync(parent.number()) != 0) {
    return ioError(target_.parent_path(), {errno, std::generic_category()});
  }
  return {};
}

}  // namespace tactus::session
