// Whole files: read with a size limit, written so that they appear whole or not at all.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace tactus::base {

/// What is read at most of what is piped in, which may never end.
inline constexpr std::size_t kMostPipeBytes = std::size_t{256} << 20U;

/// The bytes of `path`, or an error where it cannot be read or holds more than `most_bytes`.
/// The size is looked at before anything is read, so a huge file costs nothing. A pipe or device of this name is
/// refused: it would be waited for, or never end. What a shell pipes in (`/dev/fd/63`, `/dev/stdin`) is read,
/// at most kMostPipeBytes of it.
Result<std::string> readFile(const std::string& path, std::size_t most_bytes);

/// SHA-256 of the file `path`, which may be larger than the memory. Careful with a database that this process has open:
/// reading it here takes the locks of SQLite away.
Result<std::string> fileSha256(const std::string& path);

/// SHA-256 of what `sha256sum` would print of the files `names` in `folder`, in this order; those that are not there
/// are left out.
Result<std::string> listingSha256(const std::string& folder, const std::vector<std::string>& names);

/// Writes `bytes` to `path` through a temporary file beside it: synced, then renamed over `path`. On an error the old
/// file, or its absence, stays as it was. A symbolic link is followed, so the file it names is replaced. What is no
/// regular file (a device, a pipe) is written into. A file that is replaced keeps its mode.
Result<void> writeFileAtomically(const std::string& path, std::string_view bytes);

/// Waits until the names in the folder of `path` are on the disk; 0 or the number of the error. A folder that cannot be
/// asked counts as done: one that may be written into but not listed, or one on a file system that keeps names in
/// order.
int syncFolderOf(const std::string& path);

/// An error where `path` leads out of `folder` by links: a folder that came from elsewhere must not reach other files.
Result<void> requireBelow(const std::string& folder, const std::string& path);

enum class FolderMode {
  kUsual,
  kPrivate,  ///< a new folder is only the user's (0700); its parents are as usual
};

/// Makes the folder `path` and its parents where they are missing.
Result<void> makeFolder(const std::string& path, FolderMode mode = FolderMode::kUsual);

}  // namespace tactus::base
