// What the safety layer promises at every tick, whatever source, hand, device and program do.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "core/base/random.h"

#include "tests/core/haptics/safety/safety_loop.h"
#include "tests/support/day.h"

namespace tactus::haptics {
namespace {

constexpr double kNever = -1e9;

/// Everything that can go wrong, at random: a source with jumps and NaN, a hand that jerks, ticks that come late, a
/// device that falls silent or reports faults, a button that bounces, a program that hangs.
class Adversary {
 public:
  explicit Adversary(std::uint64_t seed) : random_(seed) {
    loop.limits.force_cap_n = random_.uniform(0.1, 3);
    loop.limits.slew_n_s = random_.uniform(20, 250);
    loop.limits.release_slew_n_s = random_.uniform(200, 500);
    loop.limits.guard_velocity = random_.below(2) == 0;
    loop.limits.loop_delay_s = 0.001 * random_.below(5);
    loop.limits.continuous_force_n = random_.uniform(0.2, 0.88);
    loop.limits.thermal_window_s = 10;
    const EnableKind kinds[] = {EnableKind::kButton, EnableKind::kPedal, EnableKind::kKey, EnableKind::kLatch};
    loop.enable.kind = kinds[random_.below(4)];
    // Half of the runs are calm, so that forces last.
    trouble_ = random_.below(2) == 0 ? 0.1 : 1;
    watched_program_ = random_.below(2) == 0;
  }

  SafetyLoop loop;
  double step_ms = 1;
  bool down = false;
  bool cuts = false;  ///< something in the last tick allows no fade

  void tick() {
    source();
    hand();
    device();
    program();
    step_ms = 1;
    if (chance(0.01)) step_ms = random_.uniform(0.2, 4);
    if (chance(0.001)) step_ms = random_.uniform(4, 150);
    const bool fading = !loop.safety.enabled() && loop.out.force_n != 0;
    loop.input.stop = chance(fading ? 0.02 : 0.0002);
    const DeviceFault fault = loop.device.fault;
    const bool sound =
        fault == DeviceFault::kNone || fault == DeviceFault::kWarmMotors || fault == DeviceFault::kForceLimited;
    cuts = loop.input.stop || !sound || !std::isfinite(loop.asked_n) || !std::isfinite(loop.input.position_mm);
    loop.tick(step_ms);
  }

 private:
  bool chance(double share) { return random_.uniform() < trouble_ * share; }

  void source() {
    if (random_.below(200) == 0) level_n_ = random_.uniform(-4, 4);
    if (random_.below(500) == 0) noise_n_ = random_.uniform(0, 3);
    loop.asked_n = level_n_ + noise_n_ * random_.normal();
    if (chance(0.0002)) loop.asked_n = random_.below(2) == 0 ? std::nan("") : std::numeric_limits<double>::infinity();
    if (chance(0.001)) loop.asked_n = 1e300;
    if (random_.below(1000) == 0) loop.input.follows_motion = random_.below(2) == 0;
  }
  void hand() {
    if (random_.below(100) == 0) speed_mm_s_ = 150 * random_.normal();
    if (random_.below(50) == 0) speed_mm_s_ = 0;
    position_mm_ += 0.001 * speed_mm_s_ + 0.02 * random_.normal();
    position_mm_ *= 0.9995;
    if (chance(0.0003)) position_mm_ += 30 * random_.normal();
    loop.input.position_mm = 0.055 * std::round(position_mm_ / 0.055);
    if (chance(0.0001)) loop.input.position_mm = std::nan("");
    if (random_.below(down ? 800 : 200) == 0) down = !down;
    bool contact = down;
    if (chance(0.002)) contact = !contact;
    const bool by_program = loop.enable.kind == EnableKind::kPedal || loop.enable.kind == EnableKind::kKey;
    loop.press(contact && !by_program);
    loop.input.pedal = contact && by_program;
    down = contact;
  }
  void device() {
    if (chance(0.001)) silent_ = random_.below(60);
    loop.sampling = silent_-- <= 0;
    if (chance(0.0005)) stuck_ = random_.below(60);
    loop.writing = stuck_-- <= 0;
    loop.device.fault = DeviceFault::kNone;
    if (chance(0.0001)) loop.device.fault = static_cast<DeviceFault>(random_.below(7));
  }
  void program() {
    const bool working = loop.input.armed && !loop.safety.tripped();
    if (random_.below(working ? 4000 : 100) == 0) loop.input.armed = !loop.input.armed;
    if (!watched_program_) return;
    if (chance(0.0005)) hung_ = random_.below(1500);
    if (hung_-- <= 0) loop.input.heartbeat_ns = loop.now_ns;
  }

  base::Random random_;
  double trouble_;
  bool watched_program_;
  double level_n_ = 0, noise_n_ = 0;
  double position_mm_ = 0, speed_mm_s_ = 0;
  int silent_ = 0, stuck_ = 0, hung_ = 0;
};

/// Follows a run and checks each tick against what went in, with arithmetic of its own.
class Watch {
 public:
  void check(const Adversary& adversary) {
    const SafetyLoop& loop = adversary.loop;
    const LimitSettings& limits = loop.limits;
    const double now_s = 1e-9 * static_cast<double>(loop.now_ns);
    const double force_n = loop.out.force_n;
    const double size_n = std::abs(force_n);
    const double before_n = before_n_;
    const double step_s = 1e-3 * adversary.step_ms;
    before_n_ = force_n;

    ASSERT_TRUE(std::isfinite(force_n));
    ASSERT_LE(size_n, limits.force_cap_n);
    // Whatever was latched before, and whatever fades.
    if (adversary.cuts) {
      ASSERT_EQ(force_n, 0);
      cut_ticks += before_n != 0 ? 1 : 0;
    }
    // Away from zero by the slew of at most 2 ms. Toward it by its own slew; only a cut or a deadline may be faster.
    const bool across = force_n * before_n < 0;
    const double grown_n = across ? size_n : size_n - std::abs(before_n);
    ASSERT_LE(grown_n, limits.slew_n_s * std::min(step_s, 0.002) + kRounding);
    const double shrunk_n = across ? std::abs(before_n) : std::abs(before_n) - size_n;
    const double write_age_s = 1e-9 * static_cast<double>(loop.now_ns - loop.device.written_ns);
    const bool cut = loop.safety.tripped() || adversary.cuts || write_age_s > limits.write_trip_s;
    // A device that has had no command for longer than it holds one has let go by itself.
    const double hold_s = DeviceInfo{}.hold_s;
    const bool gap = step_s > hold_s;
    const bool let_go = gap || write_age_s + limits.loop_delay_s > hold_s;
    const bool sound = !cut && !let_go && adversary.step_ms <= 2;
    if (sound) {
      ASSERT_LE(shrunk_n, kLargestShrinkNS * step_s + kRounding);
    }

    // A latch is on with its contact up; it has its own tests.
    const bool held = adversary.down || loop.enable.kind == EnableKind::kLatch;
    forbid(up_s_, held, now_s, step_s);
    forbid(disarmed_s_, loop.input.armed, now_s, step_s);
    forbid(tripped_s_, !loop.safety.tripped(), now_s, step_s);
    const auto heartbeat_ns = loop.input.heartbeat_ns;
    const bool alive =
        heartbeat_ns == 0 || 1e-9 * static_cast<double>(loop.now_ns - heartbeat_ns) <= limits.gui_silent_s;
    forbid(silent_s_, alive, now_s, step_s);
    for (const double since_s : {up_s_, disarmed_s_, tripped_s_, silent_s_}) {
      if (since_s == kNever) continue;
      ASSERT_LE(size_n, std::max(0.0, limits.force_cap_n * (1 - (now_s - since_s) / 0.03)) + 1e-6);
    }
    const double age_s = 1e-9 * static_cast<double>(loop.now_ns - loop.device.time_ns);
    if (age_s >= limits.stale_zero_s) {
      ASSERT_EQ(force_n, 0);
    }
    if (!loop.safety.enabled() && enabled_s_ + 0.031 < now_s) {
      ASSERT_EQ(force_n, 0);
    }
    if (loop.safety.enabled()) enabled_s_ = now_s;
    ASSERT_FALSE(loop.safety.enabled() && (loop.safety.tripped() || !loop.input.armed || !alive));

    // Fade-in: no more than the share of the second that the hand has held it since arming, a silence or a gap.
    const bool anew = gap && (was_enabled_ || before_n != 0);
    if (!loop.input.armed || !alive || anew) held_s_ = 0;
    if (anew) faded_before_n_ = 0;
    was_enabled_ = loop.safety.enabled();
    if (loop.safety.enabled()) {
      held_s_ += std::min(step_s, 0.002);
      ASSERT_LE(size_n,
                std::max(faded_before_n_, limits.force_cap_n * std::min(1.0, held_s_ / limits.fade_in_s)) + 1e-9);
    }
    // A force that still fades from before a new fade-in may be larger for its 30 ms.
    faded_before_n_ = loop.safety.enabled() && size_n <= limits.force_cap_n * held_s_ ? 0 : size_n;

    // The first trip stays until the next arming.
    if (loop.input.armed && was_armed_ && first_) {
      ASSERT_EQ(loop.safety.tripped(), first_);
    }
    was_armed_ = loop.input.armed;
    first_ = loop.safety.tripped();

    ASSERT_GE(loop.safety.thermalShare(), 0);
    ASSERT_LE(loop.safety.thermalShare(), 1);
    active_ticks += size_n > 0.05 ? 1 : 0;
    trips += first_ ? 1 : 0;
  }

  int active_ticks = 0;
  int trips = 0;
  int cut_ticks = 0;  ///< that ended a force

 private:
  static constexpr double kRounding = 1e-9;
  /// The steepest slope toward zero: the slew, and for a stale device 3 N in 7.7 ms (shifted decay), at most 500 N/s.
  static constexpr double kLargestShrinkNS = 500;

  /// Notes since when something forbids a force, in s; `kNever` while it is allowed.
  static void forbid(double& since_s, bool allowed, double now_s, double step_s) {
    if (allowed) since_s = kNever;
    if (!allowed && since_s == kNever) since_s = now_s - step_s;
  }

  double before_n_ = 0;
  double up_s_ = kNever, disarmed_s_ = kNever, tripped_s_ = kNever, silent_s_ = kNever;
  double enabled_s_ = 0;
  double held_s_ = 0;
  double faded_before_n_ = 0;
  bool was_armed_ = false;
  bool was_enabled_ = false;
  Trip first_;
};

/// rms of the force as it was held, over every window that ends at a tick.
class Rms {
 public:
  void hold(double force_n, double seconds) {
    time_s_.push_back((time_s_.empty() ? 0 : time_s_.back()) + seconds);
    spent_.push_back((spent_.empty() ? 0 : spent_.back()) + force_n * force_n * seconds);
  }
  double largest(double window_s) const {
    double most = 0;
    std::size_t first = 0;  // the last tick that is older than the window
    for (std::size_t i = 0; i < time_s_.size(); ++i) {
      while (first + 1 < i && time_s_[first + 1] <= time_s_[i] - window_s) ++first;
      const bool whole = time_s_[i] > window_s;
      if (!whole) {
        most = std::max(most, spent_[i]);
        continue;
      }
      const double share = (time_s_[i] - window_s - time_s_[first]) / (time_s_[first + 1] - time_s_[first]);
      most = std::max(most, spent_[i] - spent_[first] - share * (spent_[first + 1] - spent_[first]));
    }
    return std::sqrt(most / window_s);
  }

 private:
  std::vector<double> time_s_, spent_;
};

TEST(SafetyProperties, HoldWhateverSourceHandDeviceAndProgramDo) {
  int active = 0;
  int tripped = 0;
  int cut = 0;
  const int runs = support::rounds(1500);
  for (int run = 0; run < runs; ++run) {
    const std::uint64_t seed = support::firstSeedOfToday() + static_cast<std::uint64_t>(run);
    SCOPED_TRACE(seed);
    Adversary adversary(seed);
    Watch watch;
    for (int i = 0; i < 2000; ++i) {
      adversary.tick();
      watch.check(adversary);
      if (testing::Test::HasFatalFailure()) FAIL() << "tick " << i;
    }
    active += watch.active_ticks;
    tripped += watch.trips;
    cut += watch.cut_ticks;
  }
  // The adversary leaves room for forces, for trips and for cuts.
  EXPECT_GT(cut, 0);
  EXPECT_GT(active, 200 * runs);
  EXPECT_GT(tripped, 60 * runs);
}

TEST(SafetyProperties, NoWindowIsWarmerThanTheRating) {
  int warm = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    Adversary adversary(seed);
    Rms rms;
    double held_n = 0;
    for (int i = 0; i < 60000; ++i) {
      adversary.tick();
      rms.hold(held_n, 1e-3 * adversary.step_ms);
      held_n = adversary.loop.out.force_n;
      warm += adversary.loop.limited(kLimitedByThermal) ? 1 : 0;
    }
    // Ticks are whole nanoseconds, here they are doubles.
    EXPECT_LE(rms.largest(adversary.loop.limits.thermal_window_s),
              adversary.loop.limits.continuous_force_n * (1 + 1e-6));
  }
  EXPECT_GT(warm, 10000);  // the budget was what held the force
}

TEST(SafetyProperties, SameRunSameBits) {
  Adversary one(77);
  Adversary two(77);
  for (int i = 0; i < 5000; ++i) {
    one.tick();
    two.tick();
    ASSERT_EQ(one.loop.out.force_n, two.loop.out.force_n);
    ASSERT_EQ(one.loop.out.limited, two.loop.out.limited);
  }
}

}  // namespace
}  // namespace tactus::haptics
