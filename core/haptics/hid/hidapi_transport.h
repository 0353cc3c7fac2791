// A HID device through hidapi (hidraw on Linux).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"

struct hid_device_;

namespace tactus::haptics {

// A lock on the node of a device, so that one program at a time uses it, and the name of the current holder.

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

// The reports of a HID device, as the operating system offers them.

/// One open device. At most two threads: the reader calls `readTimeout`, the writer all other functions. Byte 0 of
/// every report is its id. Each call may block; none is real-time safe.
class HidTransport {
 public:
  virtual ~HidTransport() = default;

  virtual base::Result<std::vector<std::uint8_t>> descriptor() = 0;

  /// Sends an output report. May block for seconds if the device does not accept it (5 s on Linux).
  virtual base::Result<void> write(std::span<const std::uint8_t> report) = 0;
  /// Sends a feature report.
  virtual base::Result<void> sendFeature(std::span<const std::uint8_t> report) = 0;
  /// Fetches the feature report with the id in byte 0. Returns its length including the id.
  virtual base::Result<std::size_t> getFeature(std::span<std::uint8_t> report) = 0;

  /// The oldest waiting input report; 0 if none arrived within `timeout_ms`. An error means that the device is gone.
  virtual base::Result<std::size_t> readTimeout(std::span<std::uint8_t> room, int timeout_ms) = 0;
};

/// Opens the same path twice. hidapi allows only one reading and one writing thread, and before 0.15 both write the
/// error text of their handle. While open, the node is locked for other programs that take a NodeLock.
class HidapiTransport final : public HidTransport {
 public:
  /// Opens `path`, the system's name, e.g. /dev/hidraw3. Returns an error if the device is gone, may not be opened, or
  /// is locked by another program with a NodeLock.
  static base::Result<std::unique_ptr<HidTransport>> open(const std::string& path);
  ~HidapiTransport() override;

  base::Result<std::vector<std::uint8_t>> descriptor() override;
  base::Result<void> write(std::span<const std::uint8_t> report) override;
  base::Result<void> sendFeature(std::span<const std::uint8_t> report) override;
  base::Result<std::size_t> getFeature(std::span<std::uint8_t> report) override;
  base::Result<std::size_t> readTimeout(std::span<std::uint8_t> room, int timeout_ms) override;

 private:
  HidapiTransport(std::string path, NodeLock lock, hid_device_* reads, hid_device_* writes)
      : path_(std::move(path)), lock_(std::move(lock)), reads_(reads), writes_(writes) {}
  tl::unexpected<base::Error> failed(hid_device_* handle, const char* what) const;

  std::string path_;
  NodeLock lock_;
  hid_device_* reads_;
  hid_device_* writes_;
};

/// The report descriptor that the system keeps for a hidraw node. Needs no permission for the node itself.
/// `system_folder`: /sys/class/hidraw.
base::Result<std::vector<std::uint8_t>> descriptorOfNode(const std::string& path,
                                                         const std::string& system_folder = "/sys/class/hidraw");

}  // namespace tactus::haptics
