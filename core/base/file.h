// Whole files: read with a size limit, written so that they appear whole or not at all.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace tactus::base {

/// The bytes of `path`, or an error where it cannot be read or holds more than `most_bytes`.
/// The size is looked at before anything is read, so a huge file costs nothing. A pipe or device of this name is
/// refused: it would be waited for, or never end. What a shell pipes in (`/dev/fd/63`, `/dev/stdin`) is read.
Result<std::string> readFile(const std::string& path, std::size_t most_bytes);

/// Writes `bytes` to `path` through a temporary file beside it: synced, then renamed over `path`. On an error the old
/// file, or its absence, stays as it was. A symbolic link is followed, so the file it names is replaced. What is no
/// regular file (a device, a pipe) is written into.
Result<void> writeFileAtomically(const std::string& path, std::string_view bytes);

/// An error where `path` leads out of `folder` by links: a folder that came from elsewhere must not reach other files.
Result<void> requireBelow(const std::string& folder, const std::string& path);

/// Makes the folder `path` and its parents where they are missing.
Result<void> makeFolder(const std::string& path);

}  // namespace tactus::base
