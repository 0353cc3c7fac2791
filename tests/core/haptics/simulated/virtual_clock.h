// Virtual time for tests of devices: ticks of 1 ms from an arbitrary start.
#pragma once

#include <cstdint>

namespace tactus::haptics {

inline constexpr std::int64_t kTickNs = 1'000'000;
inline constexpr std::int64_t kBeginNs = 77'123'456'789;  ///< a clock does not begin at 0

constexpr std::int64_t tickNs(int tick) { return kBeginNs + tick * kTickNs; }

}  // namespace tactus::haptics
