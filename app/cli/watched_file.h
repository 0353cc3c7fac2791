// Tells when a file has changed, by looking at it again and again: that works on every file system, and for editors
// that replace a file as well as for those that write into it.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <sys/stat.h>

namespace tactus::cli {

class WatchedFile {
 public:
  using Clock = std::chrono::steady_clock;
  /// A file that did not change for this long is whole.
  static constexpr auto kQuiet = std::chrono::milliseconds(100);

  enum class Change {
    kNone,
    kNew,      ///< it has just changed: it may be half written
    kSettled,  ///< it changed a while ago, and not since
  };

  /// The first look says that the file is new.
  explicit WatchedFile(std::string path);

  /// What has happened since the last call. `now`: not before the last one.
  Change look(Clock::time_point now);

 private:
  std::string path_;
  struct stat seen_ {};  ///< all zero: no file
  std::optional<Clock::time_point> changed_at_;
};

}  // namespace tactus::cli
