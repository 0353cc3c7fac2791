// Simulated time that follows the clock of the servo but skips the rest of a long pause.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

namespace tactus::haptics {

/// Longer than the delay and `quiet_after_s` of a default virtual device together, so after such a pause the device has
/// no force. Short enough that its simulation takes a fraction of a millisecond.
inline constexpr std::int64_t kLongestCatchUpNs = 250'000'000;

/// Real-time safe: yes.
class PausingClock {
 public:
  /// Simulated time at `now_ns`. The first call returns 0. A clock that goes back has no effect.
  std::int64_t at(std::int64_t now_ns) noexcept {
    if (!last_ns_) last_ns_ = ahead_ns_ = now_ns;
    ahead_ns_ += std::max<std::int64_t>(0, now_ns - *last_ns_ - kLongestCatchUpNs);
    last_ns_ = std::max(*last_ns_, now_ns);
    return *last_ns_ - ahead_ns_;
  }

  /// Difference between the clock and simulated time at the last call of `at`.
  std::int64_t aheadNs() const noexcept { return ahead_ns_; }

 private:
  std::optional<std::int64_t> last_ns_;
  std::int64_t ahead_ns_ = 0;
};

}  // namespace tactus::haptics
