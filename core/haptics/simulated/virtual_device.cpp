#include "core/haptics/simulated/virtual_device.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "core/base/check.h"
#include "core/base/text.h"

namespace tactus::haptics {

std::span<const SimulatedHand> handPresets() noexcept {
  static constexpr SimulatedHand kPresets[] = {kNobody, kPinch, kArm, kFiveParameters};
  return kPresets;
}

const SimulatedHand* findHand(std::string_view name) noexcept {
  for (const SimulatedHand& hand : handPresets())
    if (hand.name == name) return &hand;
  return nullptr;
}

SimulatedBody::SimulatedBody(const SimulatedHand& hand, const DeviceMechanics& device, double position_mm,
                             double speed_mm_s) noexcept
    : hand_(hand),
      device_(device),
      x_(1e-3 * position_mm),
      v_(1e-3 * speed_mm_s),
      arm_x_(1e-3 * position_mm),
      arm_v_(1e-3 * speed_mm_s) {}

void SimulatedBody::step(const HandTarget& wish, double resistance_n, double dt_s) noexcept {
  const double goal = 1e-3 * wish.position_mm;
  const double goal_speed = 1e-3 * wish.speed_mm_s;
  double hand_n = 0;
  if (hand_.arm_mass_kg > 0) {
    const double grip_n = wish.holds ? hand_.stiffness_n_m * (arm_x_ - x_) + hand_.damping_n_s_m * (arm_v_ - v_) : 0;
    const double arm_n = hand_.arm_stiffness_n_m * (goal - arm_x_) + hand_.arm_damping_n_s_m * (goal_speed - arm_v_);
    arm_v_ += dt_s * (arm_n - grip_n) / hand_.arm_mass_kg;
    arm_x_ += dt_s * arm_v_;
    hand_n = grip_n;
  } else if (wish.holds) {
    hand_n = hand_.stiffness_n_m * (goal - x_) + hand_.damping_n_s_m * (goal_speed - v_);
  }
  const double mass = device_.mass_kg + (wish.holds ? hand_.mass_kg : 0);
  v_ += dt_s * (hand_n - device_.damping_n_s_m * v_ - resistance_n) / mass;
  const double friction = std::min(std::abs(v_), dt_s * device_.dry_friction_n / mass);
  v_ -= std::copysign(friction, v_);
  x_ += dt_s * v_;
}

namespace {

constexpr std::string_view kFaultNames[] = {"unplugged", "stalled", "stuck_value", "not_a_number", "warm_motors"};
constexpr double kHuge = 1e6;

enum class Low { kIncluded, kExcluded };

struct Bounds {
  const char* place;
  double value;
  Low low_end;
  double low;
  double high;

  bool hold() const { return (low_end == Low::kIncluded ? value >= low : value > low) && value <= high; }
  std::string text() const {
    return "a number in " + std::string(low_end == Low::kIncluded ? "[" : "(") + base::formatNumber(low) + ", " +
           base::formatNumber(high) + "]";
  }
};

}  // namespace

std::string_view name(InjectedFault fault) noexcept { return kFaultNames[static_cast<int>(fault)]; }

std::optional<InjectedFault> faultNamed(std::string_view text) noexcept {
  for (int i = 0; i < static_cast<int>(std::size(kFaultNames)); ++i)
    if (kFaultNames[i] == text) return static_cast<InjectedFault>(i);
  return std::nullopt;
}

base::Result<void> check(const VirtualDeviceSettings& s) {
  const Bounds all[] = {
      {"mass_kg", s.mechanics.mass_kg, Low::kIncluded, 0.001, 100},
      {"damping_n_s_m", s.mechanics.damping_n_s_m, Low::kIncluded, 0, 1000},
      {"dry_friction_n", s.mechanics.dry_friction_n, Low::kIncluded, 0, 1000},
      {"hand.mass_kg", s.hand.mass_kg, Low::kIncluded, 0, 100},
      {"hand.damping_n_s_m", s.hand.damping_n_s_m, Low::kIncluded, 0, 1000},
      {"hand.stiffness_n_m", s.hand.stiffness_n_m, Low::kIncluded, 0, 1e5},
      {"hand.arm_mass_kg", s.hand.arm_mass_kg, Low::kIncluded, 0, 100},
      {"hand.arm_damping_n_s_m", s.hand.arm_damping_n_s_m, Low::kIncluded, 0, 1000},
      {"hand.arm_stiffness_n_m", s.hand.arm_stiffness_n_m, Low::kIncluded, 0, 1e5},
      {"start_mm", s.start_mm, Low::kIncluded, -1000, 1000},
      {"count_mm", s.count_mm, Low::kIncluded, 0, 10},
      {"delay_s", s.delay_s, Low::kIncluded, 0, 0.1},
      {"dropped_share", s.dropped_share, Low::kIncluded, 0, 1},
      {"stalls_per_s", s.stalls_per_s, Low::kIncluded, 0, 1000},
      {"shortest_stall_ms", static_cast<double>(s.shortest_stall_ms), Low::kIncluded, 1, kHuge},
      {"longest_stall_ms", static_cast<double>(s.longest_stall_ms), Low::kIncluded,
       static_cast<double>(s.shortest_stall_ms), kHuge},
      {"max_force_n", s.max_force_n, Low::kExcluded, 0, 100},
      {"continuous_force_n", s.continuous_force_n, Low::kExcluded, 0, 100},
      {"quiet_after_s", s.quiet_after_s, Low::kExcluded, 0, kHuge},
      {"live_time_constant_s", s.live_time_constant_s, Low::kIncluded, 0.002, 10},
      {"live_speed_mm_s", s.live_speed_mm_s, Low::kExcluded, 0, kHuge},
  };
  for (const Bounds& bounds : all)
    if (!bounds.hold())
      return base::fail(base::ErrorCode::kValue, std::string("device: ") + bounds.place,
                        base::formatNumber(bounds.value), bounds.text());
  if (s.steps_per_ms < 1 || s.steps_per_ms > 1000 || 1'000'000 % s.steps_per_ms != 0)
    return base::fail(base::ErrorCode::kValue, "device: steps_per_ms", std::to_string(s.steps_per_ms),
                      "a divisor of 1000000 in [1, 1000]");
  if (!(std::abs(dot(s.inwards, s.inwards) - 1) < 1e-9))
    return base::fail(base::ErrorCode::kValue, "device: inwards",
                      "a direction of length " + base::formatNumber(std::sqrt(dot(s.inwards, s.inwards))),
                      "one of length 1");
  for (std::size_t i = 0; i < s.faults.size(); ++i) {
    const FaultEvent& event = s.faults[i];
    if (!(event.start_s >= 0) || !std::isfinite(event.start_s) || !(event.duration_s > 0))
      return base::fail(
          base::ErrorCode::kValue, "device: faults[" + std::to_string(i) + "]",
          "start " + base::formatNumber(event.start_s) + " s, duration " + base::formatNumber(event.duration_s) + " s",
          "a start of at least 0 s and a duration above 0 s");
  }
  return {};
}

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

static_assert(std::atomic<double>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

void LiveHand::setTarget(double position_mm) noexcept {
  if (std::isfinite(position_mm)) target_mm_.store(position_mm, std::memory_order_relaxed);
}

void LiveHand::place(double position_mm) noexcept {
  position_mm_ = position_mm;
  speed_mm_s_ = 0;
}

HandTarget LiveHand::next() noexcept {
  constexpr double kTickS = 0.001;
  const double ahead_mm = target_mm_.load(std::memory_order_relaxed) - position_mm_;
  const double acceleration = (ahead_mm / time_constant_s_ - 2 * speed_mm_s_) / time_constant_s_;
  speed_mm_s_ = std::clamp(speed_mm_s_ + kTickS * acceleration, -largest_speed_mm_s_, largest_speed_mm_s_);
  position_mm_ += kTickS * speed_mm_s_;
  return {position_mm_, speed_mm_s_, true, button_.load(std::memory_order_relaxed)};
}

namespace {

DeviceInfo describe(const VirtualDeviceSettings& settings) {
  DeviceInfo info;
  info.id = "virtual";
  info.name = "Virtual device (simulated)";
  info.backend = "virtual";
  info.simulated = true;
  info.max_force_n = settings.max_force_n;
  info.continuous_force_n = settings.continuous_force_n;
  if (settings.count_mm > 0) info.count_mm = settings.count_mm;
  info.damping_n_s_mm = 1e-3 * settings.mechanics.damping_n_s_m;
  info.delay_s = settings.delay_s;
  info.friction_in_n = settings.mechanics.dry_friction_n;
  info.friction_out_n = settings.mechanics.dry_friction_n;
  info.hold_s = settings.quiet_after_s;
  info.quiet_after_s = settings.quiet_after_s;
  return info;
}

}  // namespace

base::Result<std::unique_ptr<VirtualDevice>> VirtualDevice::make(VirtualDeviceSettings settings) {
  if (auto checked = check(settings); !checked) return tl::unexpected(std::move(checked.error()));
  return std::unique_ptr<VirtualDevice>(new VirtualDevice(std::move(settings)));
}

VirtualDevice::VirtualDevice(VirtualDeviceSettings settings)
    : settings_(std::move(settings)),
      info_(describe(settings_)),
      live_(settings_.live_time_constant_s, settings_.live_speed_mm_s) {
  if (!settings_.plan) settings_.plan = [this](double) { return live_.next(); };
}

base::Result<void> VirtualDevice::start() {
  live_.place(settings_.start_mm);
  simulation_.emplace(settings_);
  clock_ = {};
  last_ = {};
  written_ns_ = {};
  true_position_mm_.store(settings_.start_mm, std::memory_order_relaxed);
  true_speed_mm_s_.store(0, std::memory_order_relaxed);
  true_force_n_.store(0, std::memory_order_relaxed);
  running_ = true;
  return {};
}

void VirtualDevice::stop() noexcept {
  running_ = false;
  true_force_n_.store(0, std::memory_order_relaxed);
}

DeviceState VirtualDevice::read(std::int64_t now_ns) noexcept {
  if (!running_) return last_;
  simulation_->advance(clock_.at(now_ns));

  // What is not fresh keeps its times: a pause that was left out would make it younger.
  DeviceState state = simulation_->sample();
  state.time_ns = state.number != last_.number ? state.time_ns + clock_.aheadNs() : last_.time_ns;
  state.written_ns = last_.written_ns;
  if (simulation_->writtenNs() != written_ns_) {
    written_ns_ = simulation_->writtenNs();
    state.written_ns = *written_ns_ + clock_.aheadNs();
  }
  last_ = state;
  true_position_mm_.store(simulation_->body().positionMm(), std::memory_order_relaxed);
  true_speed_mm_s_.store(simulation_->body().speedMmS(), std::memory_order_relaxed);
  true_force_n_.store(simulation_->forceInEffectN(), std::memory_order_relaxed);
  return state;
}

void VirtualDevice::write(const Vector3& force_n, std::int64_t now_ns) noexcept {
  if (!running_) return;
  simulation_->push(-dot(force_n, settings_.inwards), clock_.at(now_ns));
}

}  // namespace tactus::haptics
