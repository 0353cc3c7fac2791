// Times of the monotonic clock in seconds.
#pragma once

#include <cstdint>

namespace tactus::haptics {

/// The time from `from_ns` to `to_ns`, s. Returns 0 if the clock ran backwards. Real-time safe: yes.
constexpr double secondsBetween(std::int64_t from_ns, std::int64_t to_ns) noexcept {
  return to_ns > from_ns ? 1e-9 * static_cast<double>(to_ns - from_ns) : 0;
}

}  // namespace tactus::haptics
