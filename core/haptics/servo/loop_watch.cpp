#include "core/haptics/servo/loop_watch.h"

#include <algorithm>

#include "core/haptics/device/seconds.h"

namespace tactus::haptics {
namespace {

constexpr double kLongestLookS = 0.1;

}  // namespace

Trip LoopWatch::look(std::uint64_t ticks, std::int64_t now_ns) noexcept {
  const double since_s = looked_ ? std::min(secondsBetween(last_ns_, now_ns), kLongestLookS) : 0;
  silent_s_ = ticks == ticks_ ? silent_s_ + since_s : 0;
  looked_ = true;
  ticks_ = ticks;
  last_ns_ = now_ns;
  if (silent_s_ <= kSilentS) return {};
  return {TripCause::kServoLate, silent_s_, kSilentS, now_ns};
}

}  // namespace tactus::haptics
