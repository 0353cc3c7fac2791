// Files and folders that are made under another name beside their place. Their names tell after a crash whose they are,
// and a lock tells whether somebody still works on them.
#pragma once

#include <string>
#include <string_view>
#include <sys/types.h>

#include "core/base/files/descriptor.h"

namespace tactus::base {

/// Behind the final name stand this and six letters and digits: `study.tactus.tactus-k3Xw0a`.
inline constexpr std::string_view kUnfinishedEnding = ".tactus-";

/// In use until the descriptor is closed or the process ends. Careful with databases: closing any descriptor of a file
/// takes the locks of SQLite in this process away from it.
struct Unfinished {
  std::string path;
  Descriptor descriptor;  ///< not open: errno says why
};

/// A new, empty file beside `path`, open for reading and writing, with `mode` less what the mask of the process takes.
/// Thread: any. (umask is never called: it would change the files of other threads.)
Unfinished makeUnfinishedFile(const std::string& path, mode_t mode);

/// A new, empty folder `path` + `ending` + six letters and digits that is only the user's (0700), open and in use.
Unfinished makeUnfinishedFolder(const std::string& path, std::string_view ending);

/// Whether the file name `name` is one of `whole`, `ending`, and six letters and digits.
bool isUnfinishedName(std::string_view name, std::string_view whole, std::string_view ending = kUnfinishedEnding);

/// Takes the file or folder `path` that no process uses; a descriptor that is not open where that cannot be said for
/// certain.
Descriptor takeUnused(const std::string& path);

}  // namespace tactus::base
