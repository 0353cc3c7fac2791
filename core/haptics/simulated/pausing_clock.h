// Simulated time that follows the clock of the servo, but leaves the rest of a long pause out.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

namespace tactus::haptics {

/// Longer than any delay and `quiet_after_s` of a virtual device by default together: after such a pause it is
/// without force. Short enough that simulating it takes a fraction of a millisecond.
inline constexpr std::int64_t kLongestCatchUpNs = 250'000'000;

/// Real-time safe: yes.
class PausingClock {
 public:
  /// Simulated time at `now_ns`; the first call is 0. A clock that goes back does nothing.
  std::int64_t at(std::int64_t now_ns) noexcept {
    if (!last_ns_) last_ns_ = ahead_ns_ = now_ns;
    ahead_ns_ += std::max<std::int64_t>(0, now_ns - *last_ns_ - kLongestCatchUpNs);
    last_ns_ = std::max(*last_ns_, now_ns);
    return *last_ns_ - ahead_ns_;
  }

  /// The clock less simulated time, as of the last `at`.
  std::int64_t aheadNs() const noexcept { return ahead_ns_; }

 private:
  std::optional<std::int64_t> last_ns_;
  std::int64_t ahead_ns_ = 0;
};

}  // namespace tactus::haptics
