// The motors of a Touch, for the tests of their load.
#pragma once

namespace tactus::haptics {

inline constexpr double kRatingN = 0.88;
inline constexpr double kWindowS = 60;

}  // namespace tactus::haptics
