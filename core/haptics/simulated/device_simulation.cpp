#include "core/haptics/simulated/device_simulation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/check.h"

namespace tactus::haptics {
namespace {

constexpr std::int64_t kMillisecondNs = 1'000'000;

std::int64_t nanoseconds(double seconds) {
  constexpr double kFarAhead = 9e18;
  return static_cast<std::int64_t>(std::min(std::round(seconds * 1e9), kFarAhead));
}

}  // namespace

DeviceSimulation::DeviceSimulation(VirtualDeviceSettings settings)
    : settings_(std::move(settings)),
      step_ns_(kMillisecondNs / settings_.steps_per_ms),
      step_s_(0.001 / settings_.steps_per_ms),
      delay_ns_(nanoseconds(settings_.delay_s)),
      quiet_after_ns_(nanoseconds(settings_.quiet_after_s)),
      body_(settings_.hand, settings_.mechanics, settings_.start_mm),
      random_(settings_.seed) {
  TACTUS_CHECK(settings_.plan != nullptr);
  beginMillisecond();
}

void DeviceSimulation::beginMillisecond() noexcept {
  const double time_s = static_cast<double>(millisecond_) * 0.001;
  wish_ = settings_.plan(time_s);
  faults_ = 0;
  for (const FaultEvent& event : settings_.faults) {
    const auto now_ms = static_cast<double>(millisecond_);
    const bool on =
        now_ms >= std::round(1e3 * event.start_s) && now_ms < std::round(1e3 * (event.start_s + event.duration_s));
    faults_ |= (on ? 1U : 0U) << static_cast<int>(event.fault);
  }
  const bool stalls = random_.uniform() < settings_.stalls_per_s * 0.001;
  dropped_ = random_.uniform() < settings_.dropped_share;
  const int length_ms =
      settings_.shortest_stall_ms + random_.below(settings_.longest_stall_ms - settings_.shortest_stall_ms + 1);
  if (stalls) stalled_until_ = std::max(stalled_until_, millisecond_ + length_ms);
  if (millisecond_ < stalled_until_) faults_ |= 1U << static_cast<int>(InjectedFault::kStalled);
  ++millisecond_;
}

double DeviceSimulation::arrivingForce() noexcept {
  if (has(InjectedFault::kUnplugged)) {
    on_the_way_.take(time_ns_);
    told_n_ = 0;
    return 0;
  }
  if (!has(InjectedFault::kStalled)) {
    if (const auto force = on_the_way_.take(time_ns_)) {
      const bool finite = std::isfinite(force->force_n);
      told_n_ = finite ? std::clamp(force->force_n, -settings_.max_force_n, settings_.max_force_n) : 0;
      written_ns_ = time_ns_;
      force_fault_ = DeviceFault::kNone;
      if (!finite) force_fault_ = DeviceFault::kFailed;
      if (finite && told_n_ != force->force_n) force_fault_ = DeviceFault::kForceLimited;
    }
  }
  return written_ns_ && time_ns_ - *written_ns_ < quiet_after_ns_ ? told_n_ : 0;
}

void DeviceSimulation::advance(std::int64_t until_ns) noexcept {
  while (time_ns_ + step_ns_ <= until_ns) {
    force_n_ = arrivingForce();
    body_.step(wish_, force_n_, step_s_);
    time_ns_ += step_ns_;
    if (time_ns_ == millisecond_ * kMillisecondNs) beginMillisecond();
  }
}

void DeviceSimulation::push(double resistance_n, std::int64_t at_ns) noexcept {
  on_the_way_.push({resistance_n, at_ns + delay_ns_});
}

DeviceState DeviceSimulation::sample() noexcept {
  sample_.written_ns = written_ns_.value_or(0);
  if (has(InjectedFault::kUnplugged)) {
    sample_.fault = DeviceFault::kLost;
    return sample_;
  }
  if (has(InjectedFault::kStalled) || dropped_) return sample_;
  ++sample_.number;
  sample_.time_ns = time_ns_;
  sample_.buttons = wish_.button ? 1 : 0;
  sample_.fault = has(InjectedFault::kWarmMotors) ? DeviceFault::kWarmMotors : force_fault_;
  if (has(InjectedFault::kStuckValue)) return sample_;
  const double true_mm = body_.positionMm();
  const double count_mm = settings_.count_mm;
  const double seen_mm = count_mm > 0 ? count_mm * std::round(true_mm / count_mm) : true_mm;
  sample_.position_mm =
      (has(InjectedFault::kNotANumber) ? std::numeric_limits<double>::quiet_NaN() : seen_mm) * settings_.inwards;
  return sample_;
}

}  // namespace tactus::haptics
