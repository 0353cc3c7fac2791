#include "core/haptics/servo/thermal_follower.h"

namespace tactus::haptics {
namespace {

constexpr auto kLongestHeldNs = static_cast<std::int64_t>(1e9 * ThermalBudget::kLongestHeldS);

}  // namespace

void ThermalFollower::add(const Sample& sample, const LimitSettings& limits) noexcept {
  const double rating_n = limits.continuous_force_n;
  if (begun_ && sample.time_ns - last_ns_ > kLongestHeldNs) {
    budget_.advance(last_ns_ + kLongestHeldNs, held_n_, rating_n, limits.thermal_window_s);
    held_n_ = 0;
  }
  budget_.advance(sample.time_ns, held_n_, rating_n, limits.thermal_window_s);
  begun_ = true;
  last_ns_ = sample.time_ns;
  held_n_ = sample.force_n;
}

}  // namespace tactus::haptics
