// The reports of a HID device, as the operating system offers them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/error.h"

namespace tactus::haptics {

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

}  // namespace tactus::haptics
