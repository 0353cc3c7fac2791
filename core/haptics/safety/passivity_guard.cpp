#include "core/haptics/safety/passivity_guard.h"

#include <algorithm>
#include <cmath>

#include "core/haptics/device/device.h"
#include "core/render/low_pass.h"

namespace tactus::haptics {
namespace {

constexpr double kPlayMm = 0.06;  ///< a little more than one count of a Touch, 0.055 mm
constexpr double kLeakS = 1.5;
constexpr double kSoftestNMm = 0.1;  ///< the softest spring whose stored energy is kept as credit
constexpr double kCreditMj = 2;
constexpr double kDampFromMj = -1;
constexpr double kFadeFromMj = -2;
constexpr double kGoneMj = -4;
constexpr double kLargestDampingNSMm = 0.002;  ///< half of what a Touch can render
constexpr double kLargestDampingN = 0.5;
constexpr double kSpeedFilterS = 0.0016;  ///< 100 Hz: a slower one would damp a vibration too late

}  // namespace

void PassivityGuard::reset(std::int64_t now_ns, double position_mm) noexcept {
  newest_ = -1;
  count_ = 0;
  now_ns_ = now_ns;
  reference_mm_ = position_mm;
  energy_mj_ = 0;
  speed_mm_s_ = 0;
}

/// Mean of the force that was asked for between two times; 0 before the first.
double PassivityGuard::acted(std::int64_t from_ns, std::int64_t until_ns) const noexcept {
  double impulse = 0;
  std::int64_t end_ns = until_ns;
  for (int i = 0; i < count_ && end_ns > from_ns; ++i) {
    const Held& held = held_[static_cast<std::size_t>(newest_ - i + kRoom) % kRoom];
    const std::int64_t start_ns = std::max(held.since_ns, from_ns);
    if (start_ns >= end_ns) continue;
    impulse += held.force_n * static_cast<double>(end_ns - start_ns);
    end_ns = start_ns;
  }
  return impulse / static_cast<double>(until_ns - from_ns);
}

void PassivityGuard::observe(std::int64_t now_ns, double position_mm, double held_n, double delay_s) noexcept {
  if (now_ns <= now_ns_) return;
  newest_ = (newest_ + 1) % kRoom;
  count_ = std::min(count_ + 1, kRoom);
  held_[static_cast<std::size_t>(newest_)] = {now_ns_, held_n};
  const auto delay_ns = static_cast<std::int64_t>(1e9 * std::clamp(delay_s, 0.0, kLongestDelayS));
  const double acting_n = acted(now_ns_ - delay_ns, now_ns - delay_ns);
  const double elapsed_s = secondsBetween(now_ns_, now_ns);
  now_ns_ = now_ns;

  const double before_mm = reference_mm_;
  reference_mm_ = std::clamp(reference_mm_, position_mm - kPlayMm / 2, position_mm + kPlayMm / 2);
  const double way_mm = reference_mm_ - before_mm;
  energy_mj_ += acting_n * way_mm;

  const double stored_mj = acting_n * acting_n / (2 * kSoftestNMm);
  energy_mj_ = std::min(energy_mj_, stored_mj + kCreditMj);
  const double rest_mj = std::clamp(energy_mj_, 0.0, stored_mj);
  energy_mj_ += (rest_mj - energy_mj_) * std::min(1.0, elapsed_s / kLeakS);

  const double left = render::decay(elapsed_s, kSpeedFilterS);
  speed_mm_s_ = left * speed_mm_s_ + (1 - left) * way_mm / elapsed_s;
  if (std::abs(speed_mm_s_) < render::kSmallest) speed_mm_s_ = 0;
  if (std::abs(energy_mj_) < render::kSmallest) energy_mj_ = 0;
}

double PassivityGuard::control(double asked_n) const noexcept {
  if (energy_mj_ >= kDampFromMj) return asked_n;
  const double damping_n_s_mm =
      kLargestDampingNSMm * std::min(1.0, (kDampFromMj - energy_mj_) / (kDampFromMj - kFadeFromMj));
  const double share = std::clamp((energy_mj_ - kGoneMj) / (kFadeFromMj - kGoneMj), 0.0, 1.0);
  return share * asked_n + std::clamp(damping_n_s_mm * speed_mm_s_, -kLargestDampingN, kLargestDampingN);
}

}  // namespace tactus::haptics
