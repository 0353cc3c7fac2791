#include "app/session/leftovers.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>

#include "app/session/export_folder.h"
#include "core/base/files/unfinished.h"
#include "core/store/fresh_file.h"

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

}  // namespace tactus::session
