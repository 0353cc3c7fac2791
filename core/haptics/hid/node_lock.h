// One program at a time holds a device: a lock on its node, and whose it is.
#pragma once

#include <optional>
#include <string>

#include "core/base/error.h"

namespace tactus::haptics {

/// The program that holds a node.
struct NodeHolder {
  int process = 0;      ///< its id
  std::string program;  ///< its name; may be empty

  bool isThisProgram() const;
  /// e.g. `tactus-workbench (process 4711)`.
  std::string text() const;
};

/// Who holds the node `path` with a NodeLock; nothing: no program that can be seen does. Takes no lock.
/// `locks_file` and `process_folder`: /proc/locks and /proc. Thread: any.
std::optional<NodeHolder> holderOf(const std::string& path, const std::string& locks_file = "/proc/locks",
                                   const std::string& process_folder = "/proc");

/// Held from `take` to the end of its life; the system gives it back when the program dies. It binds programs that take
/// it (flock) and no others: a game opens the node all the same.
class NodeLock {
 public:
  /// `path` as the system names it, e.g. /dev/hidraw3. Refused: a node that cannot be opened, or that another program,
  /// or another place in this program, holds: with its name where it can be known.
  static base::Result<NodeLock> take(const std::string& path);
  ~NodeLock();
  NodeLock(NodeLock&& other) noexcept : file_(other.file_) { other.file_ = -1; }
  NodeLock& operator=(NodeLock&& other) noexcept;

 private:
  explicit NodeLock(int file) : file_(file) {}

  int file_;  ///< an open file of its own, which nothing else uses; -1: given away
};

}  // namespace tactus::haptics
