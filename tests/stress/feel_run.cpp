#include "tests/stress/feel_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <vector>

#include "core/base/check.h"
#include "core/base/random.h"
#include "core/base/text.h"
#include "core/haptics/servo/servo_core.h"
#include "core/haptics/simulated/virtual_device.h"

#include "tests/support/loop_measures.h"
#include "tests/support/ngt_model.h"

namespace tactus::stress {
namespace {

using base::Random;
using haptics::HandPlan;
using haptics::Sample;
using haptics::ServoOrders;
using render::Phase;

constexpr std::int64_t kTickNs = 1'000'000;
constexpr double kTickS = 0.001;
/// The hand holds the device once before, for the fade-in.
constexpr double kWarmUpS = 1.3;
constexpr double kStartS = 1.6;

enum class Motion { kSlowPush, kStroke, kTremor, kReversals, kPressAtSpeed, kLetGo, kRelease };
constexpr std::array kMotionNames = {"slow push",      "stroke", "hold and tremor",        "reversals",
                                     "press at speed", "let go", "button up while pushing"};

struct FeelCase {
  haptics::VirtualDeviceSettings device;
  Motion motion = Motion::kSlowPush;
  double duration_s = 0;
  double servo_dropped_share = 0;
  double servo_stalls_per_s = 0;
  int longest_servo_stall_ms = 50;
  double swaps_per_s = 0;
  bool wild_rules = false;  ///< rules at random: F_d may fall steeply with speed, which no hand can damp
  fuzzy::RendererParameters friction;
};

HandPlan planOf(Motion motion, Random& random, double& duration_s) {
  duration_s = kStartS + 4.2;
  switch (motion) {
    case Motion::kSlowPush: return haptics::push(5);
    case Motion::kStroke: {
      const double all_s[] = {0.4, 0.8, 2};
      const double stroke_s = all_s[random.below(3)];
      duration_s = kStartS + stroke_s + 0.7;
      return haptics::stroke(60, stroke_s);
    }
    case Motion::kTremor:
      return haptics::both(haptics::stroke(random.uniform(0.5, 10), 0.3), haptics::swing(random.uniform(0.1, 0.3), 10));
    case Motion::kReversals: return haptics::swing(15, 0.8);
    case Motion::kPressAtSpeed: duration_s = kStartS + 1; return haptics::push(random.uniform(100, 500));
    case Motion::kLetGo:
      duration_s = kStartS + 1.5;
      return haptics::lettingGo(haptics::pressing(haptics::push(random.uniform(20, 150))), random.uniform(0.1, 0.8));
    case Motion::kRelease: duration_s = kStartS + 1.5; return haptics::push(random.uniform(20, 150));
  }
  return {};
}

FeelCase drawn(Random& random) {
  FeelCase one;
  one.motion = static_cast<Motion>(random.below(7));
  auto& device = one.device;
  device.hand = haptics::handPresets()[static_cast<std::size_t>(random.below(4))];
  device.delay_s = 0.001 * random.below(4);
  device.seed = random.next();
  if (random.below(4) == 0) device.count_mm = random.uniform(0.01, 0.1);
  const HandPlan moving = planOf(one.motion, random, one.duration_s);
  // The button: warm-up, then pressed a little before the motion, or in the middle of it.
  const bool at_speed = one.motion == Motion::kPressAtSpeed;
  const double press_s = at_speed ? kStartS + random.uniform(0.05, 0.3) : kStartS - 0.1;
  const double until_s = one.motion == Motion::kRelease ? kStartS + random.uniform(0.2, 1) : 1e9;
  device.plan = haptics::pressing(haptics::pressing(haptics::after(kStartS, moving), 0.1, kWarmUpS), press_s, until_s);

  one.friction.stiffness_n_mm = random.below(5) == 0 ? random.uniform(0.4, 10) : random.uniform(0.1, 0.4);
  one.friction.breakaway_ratio = random.below(2) == 0 ? 0.15 : random.uniform(0.05, 0.3);
  one.friction.damping_n_s_mm = random.uniform(0, 0.002);
  if (random.below(3) == 0) device.dropped_share = 0.001;
  if (random.below(4) == 0) {
    device.stalls_per_s = random.uniform(0.2, 2);
    device.longest_stall_ms = 2 + random.below(49);
  }
  if (random.below(3) == 0) one.servo_dropped_share = 0.001;
  if (random.below(4) == 0) one.servo_stalls_per_s = random.uniform(0.2, 2);
  if (random.below(3) == 0) one.swaps_per_s = random.uniform(1, 60);
  one.wild_rules = random.below(3) == 0;
  return one;
}

fuzzy::ForceModel modelOf(const FeelCase& one, Random& random) {
  auto model = random.below(2) == 0 ? support::s4Shifted() : support::s4FiveRegions();
  if (one.wild_rules) {
    for (auto& rule : model.experts[0].rules)
      rule.then = model.output.terms[static_cast<std::size_t>(random.below(5))].id;
  }
  model.renderer = one.friction;
  return model;
}

std::shared_ptr<const haptics::ServoScene> sceneOf(const FeelCase& one, Random& random) {
  haptics::SceneSettings settings;
  settings.largest_cost_s = std::numeric_limits<double>::infinity();
  const auto scene = haptics::ServoScene::make(
      modelOf(one, random), {{"lubrication", random.uniform()}, {"neck_flexion", random.uniform(0, 90)}}, settings);
  TACTUS_CHECK(scene.has_value());
  return *scene;
}

/// How long the device holds a command, and stalls that are longer. Drawn apart, so that a number means the same hand,
/// motion and device as before these were there.
void drawGaps(FeelCase& one, std::uint64_t number) {
  Random random(0x6A9500000U + number);
  if (random.below(2) == 0) one.device.quiet_after_s = random.uniform(0.008, 0.1);
  if (random.below(3) == 0) one.longest_servo_stall_ms = 200;
}

/// Looks at one tick after the other for what must not happen.
class Watch {
 public:
  Watch(const FeelCase& one, FeelRun& run) : count_mm_(std::max(one.device.count_mm, 1e-9)), run_(run) {}

  void see(const Sample& now, bool button, double force_cap_n, const haptics::LimitSettings& limits) {
    const std::int64_t gap_ns = any_ ? now.time_ns - last_.time_ns : kTickNs;
    const double gap_s = static_cast<double>(gap_ns) * 1e-9;
    if (button) {
      button_up_ns_ = now.time_ns;
    } else if (now.time_ns - button_up_ns_ >= 30 * kTickNs && now.force_n != 0) {
      fail(now, "a force of " + base::formatNumber(now.force_n) + " N 30 ms after the button went up");
    }
    if (!std::isfinite(now.force_n) || !std::isfinite(now.depth_mm)) fail(now, "not finite");
    if (std::abs(now.force_n) > force_cap_n) fail(now, "above the cap");
    steps(now, gap_s, limits);
    energy(now);
    depth(now);
    const bool rubbed = last_.phase != Phase::kReleased && now.phase != Phase::kReleased;
    if (any_ && rubbed && now.phase != last_.phase) ++run_.transitions;
    run_.tripped = run_.tripped || now.trip != haptics::TripCause::kNone;
    any_ = true;
    last_ = now;
  }

  /// The force at the hand, each millisecond, whether the servo ticked or not: whatever stalls, it never rises faster
  /// than the slew of the longest step.
  void feel(double at_hand_n, std::int64_t now_ns, const haptics::LimitSettings& limits) {
    constexpr double kLongestStepS = 0.002;
    const double away_n = std::abs(at_hand_n) - (at_hand_n * at_hand_n_ < 0 ? 0 : std::abs(at_hand_n_));
    if (away_n > limits.slew_n_s * kLongestStepS + 1e-9) {
      Sample now;
      now.time_ns = now_ns;
      fail(now, "a jump at the hand of " + base::formatNumber(at_hand_n - at_hand_n_) + " N");
    }
    at_hand_n_ = at_hand_n;
  }

 private:
  void fail(const Sample& now, const std::string& what) {
    if (run_.violation) return;
    run_.violation = "at " + base::formatFixed(static_cast<double>(now.time_ns) * 1e-9, 3) + " s: " + what;
  }

  /// The design's slew limits. A trip, a stale device or missed ticks may take a force away at once.
  void steps(const Sample& now, double gap_s, const haptics::LimitSettings& limits) {
    const double step_n = std::abs(now.force_n - last_.force_n);
    const bool across = now.force_n * last_.force_n < 0;
    const double toward_n =
        across ? std::abs(last_.force_n) : std::max(0.0, std::abs(last_.force_n) - std::abs(now.force_n));
    const double away_n =
        across ? std::abs(now.force_n) : std::max(0.0, std::abs(now.force_n) - std::abs(last_.force_n));
    const bool cut =
        (now.limited & (haptics::kLimitedByTrip | haptics::kLimitedByStaleDevice | haptics::kLimitedByGap)) != 0 ||
        gap_s > 0.0015;
    const double needed_s = (cut && !across ? 0 : toward_n / limits.release_slew_n_s) + away_n / limits.slew_n_s;
    constexpr double kRoundingS = 1e-12;
    if (needed_s > std::min(gap_s, 0.002) + kRoundingS)
      fail(now, "a step of " + base::formatNumber(now.force_n - last_.force_n) + " N");
    if (!cut) run_.largest_step_n = std::max(run_.largest_step_n, step_n);
  }

  /// The certificate of docs/renderer.md, for the stretch and the stiffness as rendered, from each press on.
  void energy(const Sample& now) {
    if (last_.phase == Phase::kReleased) {
      stored_mj_ = 0;
      return;
    }
    const double dx = now.position_mm - last_.position_mm;
    stored_mj_ +=
        last_.stiffness_n_mm * last_.stretch_mm * dx + std::max(last_.stiffness_n_mm, now.stiffness_n_mm) * dx * dx / 2;
    const double certificate_mj = stored_mj_ - now.stiffness_n_mm * now.stretch_mm * now.stretch_mm / 2;
    run_.lowest_certificate_mj = std::min(run_.lowest_certificate_mj, certificate_mj);
    if (certificate_mj < -1e-9) fail(now, "energy from nowhere: " + base::formatNumber(certificate_mj) + " mJ");
  }

  void depth(const Sample& now) {
    if (now.phase == Phase::kReleased) return;
    if (last_.phase == Phase::kReleased) {
      stroke_ = now;
      return;
    }
    if (now.depth_mm <= 0 || now.depth_mm >= 600) {  // at the ends of the passage the way is not counted
      stroke_ = now;
      return;
    }
    const double error_mm = std::abs((now.depth_mm - stroke_.depth_mm) - (now.position_mm - stroke_.position_mm) +
                                     (now.stretch_mm - stroke_.stretch_mm));
    // Another stiffness keeps the force or the stretch, whichever makes no energy: z changes without a way.
    if (now.stiffness_n_mm != last_.stiffness_n_mm) {
      stroke_ = now;
      return;
    }
    run_.largest_depth_error_mm = std::max(run_.largest_depth_error_mm, error_mm);
    if (error_mm > count_mm_) fail(now, "the depth is off by " + base::formatNumber(error_mm) + " mm");
  }

  double count_mm_;
  FeelRun& run_;
  bool any_ = false;
  Sample last_;
  Sample stroke_;
  double at_hand_n_ = 0;
  std::int64_t button_up_ns_ = 0;
  double stored_mj_ = 0;
};

/// Limits on what is no fault but would be felt. They hold for a hand that holds the device and moves it; stalls, swaps
/// and forces that fall steeply with speed shake the hand by themselves.
void expect(const FeelCase& one, FeelRun& run) {
  if (one.device.hand.name == "none" || one.device.stalls_per_s > 0 || one.servo_stalls_per_s > 0 ||
      one.swaps_per_s > 0 || one.wild_rules)
    return;
  if (one.motion == Motion::kStroke) run.most_transitions = 6;
  if (one.motion == Motion::kReversals) run.most_transitions = 20;
  // A slow hand is a soft spring: a break-away force much above the sliding one is stick-slip, as in a real tube. The
  // ageing of docs/renderer.md leaves room for one round in 0.35 s.
  if (one.motion == Motion::kSlowPush) run.most_transitions = 2 * 12;
  // Above 0.4 N/mm one count of the device is a step of the force that a hand feels by itself; a tenth of it gets past
  // the filter.
  const double count_n = one.friction.stiffness_n_mm * one.device.count_mm;
  if (one.motion == Motion::kSlowPush)
    run.most_ripple_n = one.friction.stiffness_n_mm <= 0.4 ? 0.01 : std::max(0.02, 0.1 * count_n);
}

std::string describe(const FeelCase& one) {
  using base::formatNumber;
  const auto& device = one.device;
  return std::string(device.hand.name) + ", " + kMotionNames[static_cast<std::size_t>(one.motion)] + ", k " +
         formatNumber(one.friction.stiffness_n_mm) + ", tau " + formatNumber(one.friction.breakaway_ratio) +
         ", delay " + formatNumber(device.delay_s) + ", count " + formatNumber(device.count_mm) + ", device drops " +
         formatNumber(device.dropped_share) + " stalls " + formatNumber(device.stalls_per_s) + ", servo drops " +
         formatNumber(one.servo_dropped_share) + " stalls " + formatNumber(one.servo_stalls_per_s) + ", swaps " +
         formatNumber(one.swaps_per_s) + ", holds " + formatNumber(device.quiet_after_s) +
         (one.wild_rules ? ", wild rules" : "");
}

}  // namespace

FeelRun feelRun(std::uint64_t number) {
  Random random(0x5EED0000U + number);
  FeelCase one = drawn(random);
  drawGaps(one, number);
  FeelRun run;
  run.what = describe(one);
  expect(one, run);

  const HandPlan plan = one.device.plan;
  const auto device = haptics::VirtualDevice::make(one.device);
  TACTUS_CHECK(device.has_value() && (*device)->start().has_value());
  haptics::ServoCore core((*device)->info());
  ServoOrders orders;
  orders.source = haptics::ForceSource::kInsertion;
  orders.armed = true;
  orders.scene = sceneOf(one, random);
  orders.start_depth_mm = random.uniform(30, 300);
  orders.limits = haptics::LimitSettings::forDevice((*device)->info());
  std::uint64_t orders_number = 1;

  Watch watch(one, run);
  std::vector<support::LoopTick> felt;
  const auto ticks = static_cast<std::int64_t>(one.duration_s / kTickS);
  std::int64_t stalled_until = 0;
  for (std::int64_t i = 1; i <= ticks; ++i) {
    const std::int64_t now_ns = i * kTickNs;
    if (random.uniform() < one.servo_stalls_per_s * kTickS)
      stalled_until = i + 2 + random.below(one.longest_servo_stall_ms - 1);
    const bool dropped = random.uniform() < one.servo_dropped_share;
    const auto state = (*device)->read(now_ns);
    watch.feel((*device)->trueForceN(), now_ns, orders.limits);
    if (i < stalled_until || dropped) continue;
    std::shared_ptr<const haptics::ServoScene> freed_after_the_tick;
    if (random.uniform() < one.swaps_per_s * kTickS) {
      freed_after_the_tick = orders.scene;
      orders.scene = sceneOf(one, random);
      ++orders_number;
    }
    haptics::ServoTick tick{now_ns, state, &orders, orders_number, false, false, now_ns};
    const Sample sample = core.tick(tick);
    (*device)->write(core.axis().forceOnHand(sample.force_n), now_ns);
    watch.see(sample, (state.buttons & 1U) != 0, orders.limits.force_cap_n, orders.limits);
    if (sample.enabled && now_ns > static_cast<std::int64_t>(kStartS * 1e9) + 300 * kTickNs)
      felt.push_back({sample.position_mm, sample.force_n});
  }
  if (felt.size() > 300) run.ripple_n = support::rippleN(felt);
  return run;
}

}  // namespace tactus::stress
