#include "core/base/files/file.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <optional>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "core/base/files/checksums.h"
#include "core/base/files/descriptor.h"
#include "core/base/files/unfinished.h"

namespace tactus::base {

namespace {

tl::unexpected<Error> ioError(const std::string& path, std::string found, std::string wanted) {
  return tl::unexpected(Error{ErrorCode::kIo, path, {}, std::move(found), std::move(wanted)});
}

bool writeAll(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// Writes to something that is there and no regular file.
Result<void> writeInto(const std::string& path, std::string_view bytes) {
  // Without a reader a pipe would wait for one.
  Descriptor file(::open(path.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC));
  if (file.number() < 0 && errno == ENXIO) {
    return ioError(path, "a pipe without a reader", "a file that can be written");
  }
  if (file.number() >= 0) ::fcntl(file.number(), F_SETFL, O_WRONLY);
  if (file.number() >= 0 && writeAll(file.number(), bytes) && file.close()) return {};
  return ioError(path, systemReason(errno), "a file that can be written");
}

/// What is no file and would be waited for or never end; nothing for files, and for what a shell pipes in (/dev/fd).
std::optional<std::string> notAFile(const std::string& path) {
  std::error_code error;
  const std::string target = std::filesystem::weakly_canonical(path, error).string();
  struct stat info {};
  if (error || ::lstat(target.c_str(), &info) != 0) return std::nullopt;
  if (S_ISFIFO(info.st_mode)) return "a pipe";
  if (S_ISCHR(info.st_mode) || S_ISBLK(info.st_mode)) return "a device";
  return std::nullopt;
}

}  // namespace

Result<std::string> readFile(const std::string& path, std::size_t most_bytes) {
  if (const auto found = notAFile(path)) return ioError(path, *found, "a file");
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.number() < 0)
    return ioError(path, path.empty() ? "an empty file name" : systemReason(errno), "a readable file");
  struct stat info {};
  if (::fstat(file.number(), &info) != 0) return ioError(path, systemReason(errno), "a readable file");
  if (S_ISDIR(info.st_mode)) return ioError(path, "a folder", "a file");

  const bool regular = S_ISREG(info.st_mode);
  if (!regular) most_bytes = std::min(most_bytes, kMostPipeBytes);
  const auto too_large = [&](std::size_t size) {
    return tl::unexpected(
        Error{ErrorCode::kLimit,
              path,
              {},
              std::to_string(size) + " bytes or more",
              "at most " + std::to_string(most_bytes) + " bytes" + (regular ? "" : " of a pipe or device")});
  };
  if (std::cmp_greater(info.st_size, most_bytes)) return too_large(static_cast<std::size_t>(info.st_size));

  // A pipe says size 0, so read until the end rather than by the size.
  std::string bytes;
  constexpr std::size_t kChunk = std::size_t{1} << 20U;
  std::size_t length = 0;
  while (true) {
    if (bytes.size() < length + kChunk)
      bytes.resize(std::max(length + kChunk, static_cast<std::size_t>(info.st_size) + 1));
    const ssize_t got = ::read(file.number(), bytes.data() + length, bytes.size() - length);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return ioError(path, systemReason(errno), "a readable file");
    if (got == 0) break;
    length += static_cast<std::size_t>(got);
    if (length > most_bytes) return too_large(length);
  }
  bytes.resize(length);
  return bytes;
}

Result<std::string> fileSha256(const std::string& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  struct stat info {};
  if (!file.isOpen() || ::fstat(file.number(), &info) != 0)
    return ioError(path, systemReason(errno), "a readable file");
  if (!S_ISREG(info.st_mode)) return ioError(path, "no regular file", "a readable file");
  Sha256 hash;
  std::string chunk(std::size_t{1} << 16U, '\0');
  while (true) {
    const ssize_t got = ::read(file.number(), chunk.data(), chunk.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return ioError(path, systemReason(errno), "a readable file");
    if (got == 0) return hash.text();
    hash.add(std::string_view(chunk).substr(0, static_cast<std::size_t>(got)));
  }
}

Result<std::string> listingSha256(const std::string& folder, const std::vector<std::string>& names) {
  Sha256 listing;
  for (const auto& name : names) {
    const auto path = std::filesystem::path(folder) / name;
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) continue;
    const auto hash = fileSha256(path.string());
    if (!hash) return hash;
    listing.add(*hash + "  " + name + '\n');
  }
  return listing.text();
}

int syncFolderOf(const std::string& path) {
  const auto folder = std::filesystem::path(path).parent_path();
  const Descriptor parent(::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  // A folder that may be written into but not listed cannot be asked, and some file systems keep names in order alone.
  if (parent.number() < 0) return errno == EACCES ? 0 : errno;
  if (::fsync(parent.number()) == 0 || errno == EINVAL || errno == ENOTSUP) return 0;
  return errno;
}

Result<void> writeFileAtomically(const std::string& path, std::string_view bytes) {
  std::error_code ignored;
  std::string target = path;
  if (std::filesystem::is_symlink(path, ignored)) {
    const auto resolved = std::filesystem::canonical(path, ignored);
    if (!ignored) target = resolved.string();
  }
  struct stat info {};
  const bool exists = ::stat(path.c_str(), &info) == 0;
  if (exists && S_ISDIR(info.st_mode)) return ioError(path, "a folder", "a file name");
  // A device or a pipe is written into: putting a file in its place would destroy it.
  if (exists && !S_ISREG(info.st_mode)) return writeInto(path, bytes);

  // What replaces a file has its mode, and until then no other user reads it.
  auto [temporary, file] = makeUnfinishedFile(target, exists ? 0600 : 0666);
  if (!file.isOpen()) return ioError(path, systemReason(errno), "a folder that can be written to");

  const bool written = writeAll(file.number(), bytes) &&
                       (!exists || ::fchmod(file.number(), info.st_mode & 07777U) == 0) && ::fsync(file.number()) == 0;
  const int write_error = errno;
  if (!written || !file.close() || std::rename(temporary.c_str(), target.c_str()) != 0) {
    const std::string why = systemReason(written ? errno : write_error);
    ::unlink(temporary.c_str());
    return ioError(path, why, "a file that can be written");
  }
  // The rename itself must survive a power cut too.
  if (const int error = syncFolderOf(target); error != 0) {
    return ioError(path, systemReason(error),
                   "a folder that keeps its names (the file is written, but a power cut may undo it)");
  }
  return {};
}

Result<void> requireBelow(const std::string& folder, const std::string& path) {
  std::error_code error;
  const auto whole = std::filesystem::weakly_canonical(path, error);
  const auto root = std::filesystem::weakly_canonical(folder, error);
  const auto [end, unused] = std::mismatch(root.begin(), root.end(), whole.begin(), whole.end());
  if (error || end == root.end()) return {};
  return ioError(path, "a link to " + base::quoted(whole.string()) + ", outside of the folder",
                 "a file in the folder itself");
}

Result<void> makeFolder(const std::string& path, FolderMode mode) {
  std::error_code error;
  if (mode == FolderMode::kPrivate) {
    const auto parent = std::filesystem::path(path).parent_path();
    if (!parent.empty()) std::filesystem::create_directories(parent, error);
    if (!error && ::mkdir(path.c_str(), 0700) == 0) return {};
  }
  std::filesystem::create_directories(path, error);
  if (error || !std::filesystem::is_directory(path)) {
    return ioError(path, error ? error.message() : "a file", "a folder that can be made");
  }
  return {};
}

}  // namespace tactus::base
