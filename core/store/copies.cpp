#include "core/store/copies.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <string_view>

namespace tactus::store {
namespace {

namespace fs = std::filesystem;

constexpr int kDeepest = 3;
constexpr std::size_t kChunk = std::size_t{1} << 20U;
constexpr std::size_t kShortestCode = 3;
constexpr std::array<std::string_view, 7> kEndings = {".tactus", ".json", ".csv", ".html", ".md", ".svg", ".tsv"};

/// Files in which one of some texts stands, read piece by piece.
class Search {
 public:
  Search(const study::RecordId& person, std::span<const std::string> codes) {
    wanted_.emplace_back(person.bytes.begin(), person.bytes.end());
    wanted_.push_back(study::toText(person));
    for (const auto& code : codes) {
      if (code.size() >= kShortestCode) wanted_.push_back(code);
    }
    for (const auto& text : wanted_) longest_ = std::max(longest_, text.size());
  }

  bool finds(const fs::path& file) const {
    std::ifstream in(file, std::ios::binary);
    std::string window;
    std::string piece(kChunk, '\0');
    while (in) {
      in.read(piece.data(), static_cast<std::streamsize>(piece.size()));
      window.append(piece, 0, static_cast<std::size_t>(in.gcount()));
      for (const auto& text : wanted_) {
        if (window.find(text) != std::string::npos) return true;
      }
      // A text may stand across two pieces.
      if (window.size() >= longest_) window.erase(0, window.size() - (longest_ - 1));
    }
    return false;
  }

 private:
  std::vector<std::string> wanted_;
  std::size_t longest_ = 0;
};

bool hasKnownEnding(const fs::path& path) {
  const std::string name = path.filename().string();
  return std::any_of(kEndings.begin(), kEndings.end(), [&](std::string_view ending) { return name.ends_with(ending); });
}

/// What a name that begins with the study's is, after that beginning.
std::string describeTail(std::string_view tail) {
  if (tail.starts_with(".before-v")) return "a copy made before an upgrade";
  if (tail.starts_with(".copy-")) return "a copy made when the study was opened";
  if (tail.find("wal") != std::string_view::npos || tail.find("journal") != std::string_view::npos) {
    return "a journal that was kept aside";
  }
  return "left over by a program that was interrupted, or a copy";
}

bool isOwnJournal(std::string_view tail) { return tail == "-wal" || tail == "-shm" || tail == "-journal"; }

bool isRegular(const fs::path& path) {
  std::error_code error;
  return fs::symlink_status(path, error).type() == fs::file_type::regular;
}

bool isFolder(const fs::path& path) {
  std::error_code error;
  return fs::symlink_status(path, error).type() == fs::file_type::directory;
}

bool folderHolds(const fs::path& folder, const Search& search) {
  std::error_code error;
  fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    if (entry.depth() >= kDeepest - 1) entry.disable_recursion_pending();
    const fs::path& path = entry->path();
    if (isRegular(path) && (hasKnownEnding(path) || path.filename().string().find(".tactus") != std::string::npos) &&
        search.finds(path)) {
      return true;
    }
  }
  return false;
}

std::string describeFolder(const fs::path& folder) {
  std::error_code error;
  if (fs::exists(folder / "codebook.json", error)) return "an export in which the participant stands";
  return "a folder in which the participant stands";
}

std::string describeFile(const fs::path& path) {
  if (path.filename().string().ends_with(".tactus"))
    return "another study file or backup in which the participant stands";
  return "a file in which the participant stands";
}

}  // namespace

std::vector<Copy> findCopies(const std::string& path, const study::RecordId& person, std::span<const std::string> codes,
                             std::span<const std::string> also) {
  const fs::path study(path);
  const std::string beginning = study.filename().string();
  const Search search(person, codes);
  std::vector<Copy> found;
  const auto look = [&](const fs::path& folder, bool is_own) {
    std::error_code error;
    fs::directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error);
    for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
      const fs::path& there = entry->path();
      const std::string name = there.filename().string();
      if (is_own && name == beginning) continue;
      if (is_own && name.starts_with(beginning)) {
        const std::string_view tail = std::string_view(name).substr(beginning.size());
        if (!isOwnJournal(tail)) found.push_back({there.string(), describeTail(tail)});
      } else if (isFolder(there)) {
        if (folderHolds(there, search)) found.push_back({there.string(), describeFolder(there)});
      } else if (isRegular(there) && hasKnownEnding(there) && search.finds(there)) {
        found.push_back({there.string(), describeFile(there)});
      }
    }
  };
  look(study.has_parent_path() ? study.parent_path() : fs::path("."), true);
  for (const auto& folder : also) look(folder, false);
  std::sort(found.begin(), found.end(), [](const Copy& a, const Copy& b) { return a.path < b.path; });
  return found;
}

}  // namespace tactus::store
