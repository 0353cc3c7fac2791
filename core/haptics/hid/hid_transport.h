// The way to a HID device: what the operating system offers for its reports.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/error.h"

namespace tactus::haptics {

/// One open device. Two threads at most: `readTimeout` belongs to the reader, everything else to the writer. Byte 0 of
/// every report is its id. Each call may block; none is real-time safe.
class HidTransport {
 public:
  virtual ~HidTransport() = default;

  virtual base::Result<std::vector<std::uint8_t>> descriptor() = 0;

  /// Sends an output report. May block for seconds where the device does not take it (5 s on Linux).
  virtual base::Result<void> write(std::span<const std::uint8_t> report) = 0;
  /// Sends a feature report.
  virtual base::Result<void> sendFeature(std::span<const std::uint8_t> report) = 0;
  /// Fetches the feature report whose id is in byte 0; returns its length with the id.
  virtual base::Result<std::size_t> getFeature(std::span<std::uint8_t> report) = 0;

  /// The oldest input report that waits; 0: none came within `timeout_ms`. An error means that the device is gone.
  virtual base::Result<std::size_t> readTimeout(std::span<std::uint8_t> room, int timeout_ms) = 0;
};

}  // namespace tactus::haptics
