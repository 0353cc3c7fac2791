// Whole files: reading with a size limit, writing so that a file appears completely or not at all.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace tactus::base {

// The reason of a system error, in words for the user.

/// The reason for `error_number` (errno) of a file or a disk, never empty. Uses the system's words. Uses our own words
/// if there is no number, if the number concerns our own handling (a closed descriptor), and for a limit on the file
/// size. Thread: any.
std::string systemReason(int error_number);

/// Whether `error_number` is a reason that concerns a file or a disk.
bool isReason(int error_number) noexcept;

/// Limit for reading from a pipe, which may never end.
inline constexpr std::size_t kMostPipeBytes = std::size_t{256} << 20U;

/// The bytes of `path`. Returns an error if the file cannot be read or is larger than `most_bytes`. Checks the size
/// before reading, so a huge file costs no time.
/// Refuses a named pipe or device, because reading could wait or never end. Reads pipes from the shell (`/dev/fd/63`,
/// `/dev/stdin`), at most kMostPipeBytes.
Result<std::string> readFile(const std::string& path, std::size_t most_bytes);

/// SHA-256 of the file `path`, which may be larger than the memory. Do not use on a database that this process has
/// open: reading it here releases SQLite's locks.
Result<std::string> fileSha256(const std::string& path);

/// SHA-256 of the output that `sha256sum` would print for the files `names` in `folder`, in this order. Skips missing
/// files.
Result<std::string> listingSha256(const std::string& folder, const std::vector<std::string>& names);

/// Writes `bytes` to a temporary file beside `path`, syncs it, and renames it to `path`. On an error the old file, or
/// its absence, is unchanged. Follows a symbolic link and replaces its target. Writes directly into a device or a pipe.
/// A replaced file keeps its mode.
Result<void> writeFileAtomically(const std::string& path, std::string_view bytes);

/// Waits until the names in the folder of `path` are on the disk; 0 or the number of the error. A folder that cannot be
/// asked counts as done: one that may be written into but not listed, or one on a file system that keeps names in
/// order.
int syncFolderOf(const std::string& path);

/// An error where `path` leads out of `folder` by links: a folder that came from elsewhere must not reach other files.
Result<void> requireBelow(const std::string& folder, const std::string& path);

enum class FolderMode {
  kUsual,
  kPrivate,  ///< a new folder is accessible to the user only (0700); new parents get the usual mode
};

/// Creates the folder `path` and its missing parents.
Result<void> makeFolder(const std::string& path, FolderMode mode = FolderMode::kUsual);

}  // namespace tactus::base
