#include "core/store/copies.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <sqlite3.h>
#include <string_view>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "core/base/error.h"
#include "core/base/files/file.h"
#include "core/base/files/unfinished.h"
#include "core/store/connection.h"
#include "core/store/opening.h"
#include "core/store/query.h"
#include "core/store/study_file.h"

namespace tactus::store {

namespace fs = std::filesystem;

base::Result<WorkFolder> WorkFolder::beside(const std::string& study) {
  auto [name, in_use] = base::makeUnfinishedFolder(study, kImportEnding);
  if (!in_use.isOpen()) {
    const std::error_code reason(errno, std::generic_category());
    std::error_code ignored;
    const auto parent = fs::absolute(study, ignored).parent_path().string();
    return tl::unexpected(
        base::Error{base::ErrorCode::kIo, parent, {}, reason.message(), "a folder that can be written into"});
  }
  return WorkFolder(std::move(name), std::move(in_use));
}

WorkFolder::WorkFolder(std::string path, base::Descriptor in_use)
    : path_(std::move(path)), in_use_(std::move(in_use)) {}
WorkFolder::WorkFolder(WorkFolder&& other) noexcept
    : path_(std::exchange(other.path_, {})), in_use_(std::move(other.in_use_)) {}
WorkFolder::~WorkFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
}

std::string WorkFolder::file(const std::string& name) const { return (fs::path(path_) / name).string(); }

namespace {

using base::Error;
using base::ErrorCode;
using base::Result;

tl::unexpected<Error> systemError(const std::string& path, int error_number, const char* wanted) {
  return tl::unexpected(Error{ErrorCode::kIo, path, {}, base::systemReason(error_number), wanted});
}

tl::unexpected<Error> thereAlready(const std::string& path) {
  return tl::unexpected(Error{ErrorCode::kIo, path, {}, "a file of this name", "a name that is not taken yet"});
}

/// Renames without ever replacing a file; 0 or the number of the error.
int renameToFree(const std::string& from, const std::string& to) {
  if (::link(from.c_str(), to.c_str()) == 0) return ::unlink(from.c_str()) == 0 ? 0 : errno;
  if (errno == EEXIST) return EEXIST;
  // Memory sticks often have file systems without links.
  struct stat info {};
  if (::lstat(to.c_str(), &info) == 0) return EEXIST;
  return ::rename(from.c_str(), to.c_str()) == 0 ? 0 : errno;
}

}  // namespace

FreshFile::FreshFile(std::string path, std::string temporary, base::Descriptor in_use)
    : path_(std::move(path)), temporary_(std::move(temporary)), in_use_(std::move(in_use)) {}

FreshFile::FreshFile(FreshFile&& other) noexcept
    : path_(std::move(other.path_)),
      temporary_(std::exchange(other.temporary_, {})),
      in_use_(std::move(other.in_use_)) {}

FreshFile::~FreshFile() {
  if (temporary_.empty()) return;
  for (const char* tail : {"", "-wal", "-journal"}) ::unlink((temporary_ + tail).c_str());
}

Result<FreshFile> FreshFile::beside(const std::string& path) {
  struct stat info {};
  if (path.empty()) return systemError(path, ENOENT, "a file name");
  if (::lstat(path.c_str(), &info) == 0) return thereAlready(path);
  for (const char* tail : {"-wal", "-journal", "-shm"}) {
    const std::string rest = path + tail;
    if (::lstat(rest.c_str(), &info) != 0) continue;
    return tl::unexpected(Error{ErrorCode::kIo,
                                path,
                                {},
                                "what another study of this name left (" + base::quoted(rest) + ")",
                                "a name beside which nothing is left; move that file away or take another name"});
  }
  auto [temporary, in_use] = base::makeUnfinishedFile(path, 0600);
  if (!in_use.isOpen()) return systemError(path, errno, "a folder in which files can be made");
  return FreshFile(path, std::move(temporary), std::move(in_use));
}

Result<void> FreshFile::place() {
  int error = ::fsync(in_use_.number()) == 0 ? 0 : errno;
  if (error == 0) error = renameToFree(temporary_, path_);
  if (error == EEXIST) return thereAlready(path_);
  if (error != 0) return systemError(path_, error, "a file that can be written");
  temporary_.clear();
  in_use_.close();  // before the database is opened: a later close would take its locks away
  error = base::syncFolderOf(path_);
  if (error != 0) return systemError(path_, error, "a folder that can be synced");
  return {};
}

Error FreshFile::renamed(Error error) const {
  if (error.file == temporary_) error.file = path_;
  return error;
}

namespace {

namespace fs = std::filesystem;

std::string nameOf(const std::string& path, int number) { return path + ".copy-" + std::to_string(number); }

tl::unexpected<base::Error> failure(const std::string& path, const std::error_code& error) {
  return tl::unexpected(
      base::Error{base::ErrorCode::kIo, path, {}, error.message(), "a folder in which copies of the study are kept"});
}

}  // namespace

base::Result<void> keepCopy(const StudyFile& file) {
  const std::string& path = file.path();
  const std::string made = nameOf(path, 0);
  std::error_code error;
  fs::remove(made, error);  // of a program that was interrupted
  if (auto copied = backUp(file, made); !copied) return copied;
  const auto mode = fs::status(path, error).permissions();
  if (!error) fs::permissions(made, mode, error);
  if (!error && fs::exists(nameOf(path, 1))) fs::rename(nameOf(path, 1), nameOf(path, 2), error);
  if (!error) fs::rename(made, nameOf(path, 1), error);
  if (!error) return {};
  const auto why = error;
  fs::remove(made, error);
  return failure(nameOf(path, 1), why);
}

base::Result<void> removeCopies(const std::string& path) {
  for (const int number : {0, 1, 2}) {
    std::error_code error;
    fs::remove(nameOf(path, number), error);
    if (error) return failure(nameOf(path, number), error);
  }
  return {};
}

namespace {

/// Copies all pages in one go; SQLite syncs the copy when it is complete. It needs no journal: where the copying fails,
/// the whole file is thrown away. (SQLiteCpp's Backup does not tell why it failed.)
void copyPages(Connection& from, Connection& to) {
  to.database().exec("PRAGMA journal_mode = OFF");
  sqlite3* target = to.database().getHandle();
  sqlite3_backup* backup = sqlite3_backup_init(target, "main", from.database().getHandle(), "main");
  if (backup == nullptr) throw SQLite::Exception(target);
  const int stepped = sqlite3_backup_step(backup, -1);
  sqlite3_backup_finish(backup);
  if (stepped != SQLITE_DONE) throw SQLite::Exception(sqlite3_errstr(stepped), stepped);
}

}  // namespace

Result<void> copyDatabase(Connection& connection, const std::string& target) {
  TACTUS_TRY(auto fresh, FreshFile::beside(target));
  try {
    Connection copy(fresh.temporary(), Connection::Mode::kReadWrite, connection.vfs());
    auto copied = guarded(copy, [&] {
      copyPages(connection, copy);
      // The copy is a file of its own, so that no journal of the study can pass for its journal.
      OpeningWriter(copy).write({newToken(), {}, readOpening(copy).commits, false, 0});
      Query truncate(copy, "PRAGMA wal_checkpoint(TRUNCATE)");
      if (!truncate.next() || truncate.integer() != 0) {
        refuse(ErrorCode::kIo, "copy", "a journal that could not be emptied", "a copy that stands alone");
      }
      for (const char* check : {"integrity_check", "foreign_key_check"}) {
        const std::string finding = copy.firstFinding(check);
        if (!finding.empty()) refuse(ErrorCode::kMismatch, "copy", finding, "an intact copy of the study");
      }
      copy.leaveJournalOnClose(false);
    });
    if (!copied) return tl::unexpected(fresh.renamed(copied.error()));
  } catch (const Refusal& refusal) {
    return base::inFile(fresh.renamed(refusal.error), target);
  } catch (const SQLite::Exception& exception) {
    return tl::unexpected(describeFailure(target, failureOf(exception)));
  }
  return fresh.place();
}

Result<void> backUp(const StudyFile& file, const std::string& target) {
  if (file.connection().batch != Connection::BatchState::kNone) {
    return base::inFile({ErrorCode::kIo, {}, {}, "a batch that is not finished", "a study at rest"}, file.path());
  }
  return copyDatabase(file.connection(), target);
}

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
