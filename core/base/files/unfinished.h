// Files and folders under construction, under a temporary name beside their final place. After a crash the name
// identifies the owner, and a lock shows whether a process still uses them.
#pragma once

#include <string>
#include <string_view>
#include <sys/types.h>

#include "core/base/files/descriptor.h"

namespace tactus::base {

/// The temporary name is the final name, this ending, and six letters and digits: `study.tactus.tactus-k3Xw0a`.
inline constexpr std::string_view kUnfinishedEnding = ".tactus-";

/// In use until the descriptor is closed or the process ends. Caution with databases: closing any descriptor of a file
/// releases SQLite's locks on it in this process.
struct Unfinished {
  std::string path;
  Descriptor descriptor;  ///< not open on failure; errno gives the reason
};

/// Creates an empty file beside `path`, open for reading and writing, with `mode` reduced by the umask. Thread: any.
/// Never calls umask, because that would affect the files of other threads.
Unfinished makeUnfinishedFile(const std::string& path, mode_t mode);

/// Creates an empty folder `path` + `ending` + six letters and digits. It is accessible to the user only (0700), open
/// and in use.
Unfinished makeUnfinishedFolder(const std::string& path, std::string_view ending);

/// Deletes what this process has made so and neither finished nor deleted yet: for a program that ends at once. What
/// stays whole otherwise, such as a study, is not among it. Thread: any.
void removeUnfinished() noexcept;

/// While one lives, `removeUnfinished` waits: for the moment in which the old and the new stand under other names.
class Exchange {
 public:
  Exchange();
  ~Exchange();
  Exchange(const Exchange&) = delete;
  Exchange& operator=(const Exchange&) = delete;
};

/// Whether a name is just being drawn or exchanged: a thread that stands still now would keep `removeUnfinished`
/// waiting. May be asked in a signal handler.
bool isExchanging() noexcept;

/// Whether the file name `name` consists of `whole`, `ending`, and six letters and digits.
bool isUnfinishedName(std::string_view name, std::string_view whole, std::string_view ending = kUnfinishedEnding);

/// Opens the file or folder `path` and locks it, if no process uses it. Returns a closed descriptor if that is not
/// certain.
Descriptor takeUnused(const std::string& path);

}  // namespace tactus::base
