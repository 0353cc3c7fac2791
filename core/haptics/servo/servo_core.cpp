#include "core/haptics/servo/servo_core.h"

#include <algorithm>

#include "core/base/check.h"

namespace tactus::haptics {
namespace {

/// Damping of a pinch grip, which holds the stylus whenever there is a force (design: 1.7 N s/m).
constexpr double kPinchGripNSMm = 0.0017;
/// How much of the passive stiffness is used: counts, dry friction and the model's own slope take their share.
constexpr double kStiffnessShare = 0.5;

bool sameAxis(const AxisMapping& a, const AxisMapping& b) noexcept {
  return a.inwards() == b.inwards() && a.originMm() == b.originMm();
}

}  // namespace

ServoCore::ServoCore(const DeviceInfo& device, const ThermalBudget& thermal)
    : period_s_(1 / device.rate_hz),
      largest_stiffness_n_mm_(largestStiffnessNMm(device)),
      safety_(device.hold_s, thermal),
      insertion_(largest_stiffness_n_mm_) {}

Sample ServoCore::tick(const ServoTick& tick) noexcept {
  const ServoOrders& orders = *tick.orders;
  // A force goes to zero along the axis that it came from; then the other one is in force, and the hand presses anew.
  const bool turned = !sameAxis(axis_, orders.axis);
  const bool another_axis = turned && force_n_ == 0;
  if (another_axis) axis_ = orders.axis;
  const double position_mm = axis_.positionMm(tick.device.position_mm);
  // Two ticks at the same time are told from each other; a long one is for the watchdogs.
  const double dt_s =
      ticks_ == 0 ? period_s_ : std::max(render::kShortestTickS, static_cast<double>(tick.now_ns - last_ns_) * 1e-9);
  ++ticks_;
  last_ns_ = tick.now_ns;
  // From nowhere, or along another axis, there is no motion.
  if (!sampled_ || another_axis) insertion_.forgetPosition();
  sampled_ = tick.device.number > 0;

  SafetyInput input;
  input.now_ns = tick.now_ns;
  input.position_mm = position_mm;
  input.device = &tick.device;
  input.armed = orders.armed;
  input.pedal = tick.pedal;
  input.stop = tick.stop;
  input.heartbeat_ns = tick.heartbeat_ns;
  input.follows_motion = orders.source == ForceSource::kInsertion;
  input.another_axis = another_axis;
  input.let_go = turned;
  safety_.begin(input, orders.enable, orders.limits);

  if (orders.scale != scale_) takeScale(orders.scale);
  const double source_n = sources(tick, position_mm, dt_s);
  const LimitedForce limited = safety_.limit(source_n / scale_, orders.limits);
  force_n_ = limited.force_n;

  Sample sample = sampleOf(tick);
  sample.position_mm = position_mm;
  sample.source_force_n = source_n;
  sample.force_n = limited.force_n * scale_;
  sample.limited |= limited.limited;
  return sample;
}

/// A device that gives a share of the force renders a spring that is stiffer by as much. What is in the hand goes on
/// under the slew limit.
void ServoCore::takeScale(double scale) noexcept {
  constexpr double kFadeS = 0.05;
  scale_ = std::max(1.0, scale);
  insertion_.limitStiffness(largest_stiffness_n_mm_ * scale_, kFadeS);
}

/// The active source, and what the others still fade: each lets go within 30 ms of its own.
double ServoCore::sources(const ServoTick& tick, double position_mm, double dt_s) noexcept {
  const ServoOrders& orders = *tick.orders;
  const bool enabled = safety_.enabled();

  if (placement_ != orders.placement) insertion_.place(orders.start_depth_mm);
  placement_ = orders.placement;

  render::InsertionTick insertion;
  insertion.active = orders.source == ForceSource::kInsertion;
  insertion.enabled = enabled;
  insertion.position_mm = position_mm;
  insertion.force_cap_n = orders.limits.force_cap_n * scale_;
  insertion.scene = orders.scene.get();
  if (orders.scene) insertion.fade_s = orders.scene->fadeS();
  insertion.dt_s = dt_s;
  const double insertion_n = insertion_.tick(insertion);
  const render::Fault fault = insertion_.state().fault;
  if (enabled && insertion.active && fault != render::Fault::kNone)
    safety_.trip({TripCause::kRenderer, static_cast<double>(fault), 0, tick.now_ns});

  StimulusTick stimulus;
  stimulus.active = orders.source == ForceSource::kStimulus;
  stimulus.enabled = enabled;
  stimulus.position_mm = position_mm;
  stimulus.dt_s = dt_s;
  stimulus.scale = scale_;
  return insertion_n + stimulus_.tick(stimulus, orders.stimulus, orders.limits);
}

Sample ServoCore::sampleOf(const ServoTick& tick) const noexcept {
  const render::RendererState& tube = insertion_.state();
  const bool engaged = tube.phase != render::Phase::kReleased;
  Sample sample;
  sample.scale = scale_;
  sample.tick = ticks_;
  sample.time_ns = tick.now_ns;
  sample.read_age_ns = tick.device.number > 0 ? tick.now_ns - tick.device.time_ns : 0;
  sample.orders = tick.orders_number;
  sample.speed_mm_s = tube.speed_mm_s.value;
  sample.depth_mm = tube.depth_mm;
  sample.slip_speed_mm_s = tube.slip_speed_mm_s.value;
  sample.stretch_mm = tube.stretch_mm;
  sample.model_force_n = engaged ? tube.dynamic_n : 0;
  sample.stiffness_n_mm = insertion_.rendered().stiffness_n_mm;
  sample.since_full_s = stimulus_.sinceFullS();
  sample.stroke = tube.stroke.number;
  sample.buttons = tick.device.buttons;
  if (engaged && insertion_.stiffnessLimited()) sample.limited = kLimitedByStiffness;
  sample.source = tick.orders->source;
  sample.stimulus = stimulus_.phase();
  sample.phase = tube.phase;
  sample.trip = safety_.tripped().cause;
  sample.enabled = safety_.enabled();
  sample.held = engaged && tube.held;
  return sample;
}

double largestStiffnessNMm(const DeviceInfo& device) noexcept {
  TACTUS_CHECK(device.rate_hz > 0 && device.delay_s >= 0 && device.damping_n_s_mm >= 0);
  const double damping_n_s_mm = device.damping_n_s_mm + kPinchGripNSMm;
  const double passive_n_mm = damping_n_s_mm / (0.5 / device.rate_hz + device.delay_s);
  return std::min(kStiffnessShare * passive_n_mm, device.max_stiffness_n_mm.value_or(passive_n_mm));
}

}  // namespace tactus::haptics
