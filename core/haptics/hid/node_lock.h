// A lock on the node of a device, so that one program at a time uses it, and the name of the current holder.
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

/// The program that holds the node `path` with a NodeLock; empty if no visible program does. Takes no lock.
/// `locks_file` and `process_folder`: /proc/locks and /proc. Thread: any.
std::optional<NodeHolder> holderOf(const std::string& path, const std::string& locks_file = "/proc/locks",
                                   const std::string& process_folder = "/proc");

/// A lock from `take` to the end of its life. If the program dies, the system releases it. It binds only programs that
/// take it (flock); a game can still open the node.
class NodeLock {
 public:
  /// Takes the lock of `path`, the system's name, e.g. /dev/hidraw3. Returns an error if the node cannot be opened, or
  /// if another program or another object of this program holds it. The error names the holder if it is known.
  static base::Result<NodeLock> take(const std::string& path);
  ~NodeLock();
  NodeLock(NodeLock&& other) noexcept : file_(other.file_) { other.file_ = -1; }
  NodeLock& operator=(NodeLock&& other) noexcept;

 private:
  explicit NodeLock(int file) : file_(file) {}

  int file_;  ///< its own open file, not shared; -1: moved away
};

}  // namespace tactus::haptics
