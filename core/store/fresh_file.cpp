#include "core/store/fresh_file.h"

#include <cerrno>
#include <filesystem>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "core/base/files/file.h"
#include "core/base/files/system_reason.h"
#include "core/base/files/unfinished.h"

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

}  // namespace tactus::store
