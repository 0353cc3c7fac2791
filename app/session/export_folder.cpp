#include "app/session/export_folder.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "app/session/study_export.h"
#include "app/session/study_source.h"
#include "app/session/trials.h"
#include "core/base/files/file.h"
#include "core/base/files/unfinished.h"
#include "core/store/copies.h"
#include "core/study/record_id.h"
#include "core/study/table_line.h"

namespace tactus::session {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kRandomLetters = 6;
constexpr std::array<std::string_view, 3> kJournalTails = {"-wal", "-journal", "-shm"};

fs::path whole(const std::string& path) {
  std::error_code error;
  fs::path found = fs::weakly_canonical(fs::absolute(path, error), error);
  if (error) found = path;
  return found.has_filename() ? found : found.parent_path();
}

/// `name` without the end of a journal's name.
std::string_view withoutTail(std::string_view name) {
  for (const auto tail : kJournalTails) {
    if (name.ends_with(tail)) return name.substr(0, name.size() - tail.size());
  }
  return name;
}

/// Whether `name` is a name of ours of anything.
bool isOurName(std::string_view name) {
  name = withoutTail(name);
  if (name.size() <= base::kUnfinishedEnding.size() + kRandomLetters) return false;
  const auto base_name = name.substr(0, name.size() - base::kUnfinishedEnding.size() - kRandomLetters);
  return base::isUnfinishedName(name, base_name);
}

/// Whether `name` ends in `ending` and a number.
bool isNumbered(std::string_view name, std::string_view ending) {
  const auto digits = name.find_last_not_of("0123456789");
  return digits != std::string_view::npos && digits + 1 < name.size() && name.substr(0, digits + 1).ends_with(ending);
}

/// Begins like a database, or holds nothing yet.
bool isDatabaseOrEmpty(const fs::path& path) {
  constexpr std::string_view kMagic{"SQLite format 3\0", 16};
  std::array<char, kMagic.size()> begin{};
  std::ifstream file(path, std::ios::binary);
  file.read(begin.data(), begin.size());
  return file.gcount() == 0 || std::string_view(begin.data(), static_cast<std::size_t>(file.gcount())) == kMagic;
}

/// What an older Tactus left: `study.tactus.a1B2c3`, or an export `.new-1` or `.old-1`.
bool looksLeft(const fs::directory_entry& entry, const std::string& name, const std::string& study) {
  std::error_code error;
  if (entry.is_directory(error)) {
    return (isNumbered(name, ".new-") || isNumbered(name, ".old-")) && isExport(entry.path());
  }
  return entry.is_regular_file(error) && base::isUnfinishedName(withoutTail(name), study, ".") &&
         isDatabaseOrEmpty(entry.path());
}

/// No program has the file open, nor the file whose journal it is.
bool isUnused(const fs::path& path) {
  const std::string text = path.string();
  const std::string main(withoutTail(text));
  std::error_code error;
  return !fs::exists(fs::symlink_status(main, error)) || base::takeUnused(main).isOpen();
}

/// What `is_left` says of an entry: that it is left over, and whether it is ours.
template <class IsLeft>
std::vector<Leftover> found(const fs::path& folder, IsLeft is_left) {
  std::vector<Leftover> leftovers;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    if (at->is_symlink(error)) continue;
    const std::optional<bool> left = is_left(*at, at->path().filename().string());
    if (left && isUnused(at->path())) leftovers.push_back({at->path().string(), *left});
  }
  std::sort(leftovers.begin(), leftovers.end(), [](const Leftover& a, const Leftover& b) { return a.path < b.path; });
  return leftovers;
}

}  // namespace

std::vector<Leftover> leftoversOfStudy(const std::string& study) {
  const fs::path path = whole(study);
  const std::string study_name = path.filename().string();
  return found(path.parent_path(), [&](const fs::directory_entry& entry, const std::string& name) {
    const bool of_import = base::isUnfinishedName(name, study_name, store::kImportEnding);
    if (of_import || isOurName(name)) return std::optional(true);
    return looksLeft(entry, name, study_name) ? std::optional(false) : std::nullopt;
  });
}

std::vector<Leftover> leftoversOfExport(const std::string& folder) {
  const fs::path path = whole(folder);
  const std::string export_name = path.filename().string();
  return found(path.parent_path(), [&](const fs::directory_entry& entry, const std::string& name) {
    if (base::isUnfinishedName(name, export_name)) return std::optional(true);
    return name.starts_with(export_name + '.') && looksLeft(entry, name, {}) ? std::optional(false) : std::nullopt;
  });
}

std::vector<std::string> removeOurs(const std::vector<Leftover>& leftovers) {
  std::vector<std::string> removed;
  for (const Leftover& leftover : leftovers) {
    // Kept until the file is gone, so that no other program takes it meanwhile.
    const auto taken = base::takeUnused(leftover.path);
    const bool is_journal = withoutTail(leftover.path) != leftover.path;
    if (!leftover.is_ours || !taken.isOpen() || (is_journal && !isUnused(leftover.path))) continue;
    std::error_code error;
    fs::remove_all(leftover.path, error);
    if (!error) removed.push_back(leftover.path);
  }
  return removed;
}

std::string sentence(const Leftover& leftover) {
  return leftover.path + (leftover.is_ours
                              ? ": left by a crash, and may hold data of the study; the next export deletes it"
                              : ": looks as if a crash had left it, and may hold data of the study; delete it unless "
                                "you made it");
}

namespace {

namespace fs = std::filesystem;
using base::Error;
using base::ErrorCode;
using base::Result;

/// What an export puts into its folder, besides recordings and models.
const std::set<std::string>& knownFiles() {
  static const std::set<std::string> files = [] {
    std::set<std::string> names = {"codebook.json", "codebook.md", std::string(kTrialsTable),
                                   std::string(kWordIntervalsTable)};
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
  return knownFiles().contains(path.generic_string()) || *path.begin() == fs::path(kPackFolder);
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
