// Virtual time for tests of devices: ticks of 1 ms from an arbitrary start.
#pragma once

#include <cstdint>

#include "tests/core/haptics/loop_numbers.h"

namespace tactus::haptics {

inline constexpr std::int64_t kBeginNs = 77'123'456'789;  ///< a clock does not begin at 0

constexpr std::int64_t tickNs(int tick) { return kBeginNs + tick * kTickNs; }

}  // namespace tactus::haptics
