// A HID device through hidapi (hidraw on Linux).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/haptics/hid/hid_transport.h"
#include "core/haptics/hid/node_lock.h"

struct hid_device_;

namespace tactus::haptics {

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
