// Numbers of a loop of 1 kHz, for its tests.
#pragma once

#include <cstdint>

namespace tactus::haptics {

inline constexpr std::int64_t kMs = 1'000'000;  // in ns
inline constexpr std::int64_t kTickNs = kMs;
inline constexpr double kCountMm = 0.055;   // of a Touch
inline constexpr double kRounding = 1e-12;  // of a few thousand additions of numbers near 1

}  // namespace tactus::haptics
