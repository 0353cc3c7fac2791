// Servo, safety layer, writer and device in virtual time: what the hand feels when the servo, or the whole program,
// stands still for a while.
#include <cmath>
#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/haptics/hid/hid_pid_device.h"
#include "core/haptics/servo/servo_core.h"

#include "tests/core/haptics/hid/pid_run.h"

namespace tactus::haptics {
namespace {

constexpr double kAskedN = 1.7;
constexpr double kFullScaleN = 10;
constexpr std::int64_t kNapNs = 200'000;

/// A stimulus of 1.7 N on the sketch's x axis; the rounds of the writer are those of HidPidDevice.
class HeldSketch {
 public:
  HeldSketch() : run_(support::PidModel::kSketch), core_(info()) {
    EXPECT_TRUE(run_.session.begin(run_.now()));
    DeviceCalibration calibration;
    calibration.full_scale_n = kFullScaleN;
    writer_.emplace(run_.session, calibration);
    orders_.source = ForceSource::kStimulus;
    orders_.armed = true;
    orders_.stimulus.number = 1;
    orders_.stimulus.force_n = kAskedN;
    orders_.axis = *AxisMapping::make({1, 0, 0});
    orders_.limits = LimitSettings::forDevice(info());
    orders_.limits.stimulus_hold_s = 1e6;
    orders_.limits.continuous_force_n = 3;
  }

  void pass(int milliseconds, bool servo_ticks, bool writer_runs) {
    for (int i = 0; i < milliseconds; ++i) pass(servo_ticks, writer_runs);
  }
  void pass(bool servo_ticks, bool writer_runs) {
    if (servo_ticks) tick();
    for (int nap = 0; nap < 5; ++nap, run_.line->now_ns += kNapNs)
      if (writer_runs) round();
    before_n = at_hand_n;
    at_hand_n = std::abs(run_.force()[0]) * kFullScaleN;
  }
  const LimitSettings& limits() const { return orders_.limits; }

  double at_hand_n = 0;
  double before_n = 0;
  Sample sample;

 private:
  static DeviceInfo info() {
    DeviceInfo info;
    info.max_force_n = kFullScaleN;
    info.hold_s = PidSession::kHoldS;
    info.delay_s = 0.0025;
    return info;
  }
  void tick() {
    DeviceState state;
    state.number = ++samples_;
    state.time_ns = run_.now();
    state.buttons = samples_ > 5 ? 1 : 0;
    state.written_ns = written_ns_;
    sample = core_.tick({run_.now(), state, &orders_, 1, false, false, run_.now()});
    writer_->commands().put({core_.axis().forceOnHand(sample.force_n), run_.now(), true});
  }
  void round() {
    const std::int64_t now_ns = run_.now();
    const bool due = now_ns - round_ns_ >= PidSession::kRefreshNs;
    if (!writer_->commands().fresh() && !writer_->letsGo(now_ns) && !due) return;
    round_ns_ = now_ns;
    if (writer_->step(now_ns)) written_ns_ = now_ns;
  }

  PidRun run_;
  ServoCore core_;
  std::optional<PidWriter> writer_;
  ServoOrders orders_;
  std::uint64_t samples_ = 0;
  std::int64_t round_ns_ = 0;
  std::int64_t written_ns_ = 0;
};

TEST(PidStall, ASecondHalfOfATenthWithoutServoEndsInAFadeInAndNotInAJump) {
  HeldSketch held;
  held.pass(1500, true, true);
  ASSERT_NEAR(held.at_hand_n, kAskedN, 1e-3);
  for (const int stall_ms : {50, 60, 80, 99}) {
    SCOPED_TRACE(stall_ms);
    held.pass(stall_ms, false, true);
    EXPECT_EQ(held.at_hand_n, 0);
    held.pass(2, true, true);
    EXPECT_LE(held.at_hand_n, 0.01);
    EXPECT_TRUE(held.sample.limited & kLimitedByGap);
    EXPECT_EQ(held.sample.trip, TripCause::kNone);
    held.pass(1100, true, true);
    EXPECT_NEAR(held.at_hand_n, kAskedN, 1e-3);
  }
}

/// With the writer alive, and without it (a program that is stopped as a whole).
TEST(PidStall, NoStallMakesTheForceAtTheHandRiseFasterThanTheSlew) {
  int zeroed = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    base::Random random(seed);
    HeldSketch held;
    held.pass(1300, true, true);
    for (int stall = 0; stall < 12 && held.sample.trip == TripCause::kNone; ++stall) {
      const int length_ms = 1 + random.below(100);
      const bool writer_runs = random.below(2) == 0;
      const auto watch = [&](int milliseconds, bool servo_ticks, bool writer) {
        for (int i = 0; i < milliseconds; ++i) {
          held.pass(servo_ticks, writer);
          // 2 ms of slew, and a step of the device (10 N in 10000).
          ASSERT_LE(held.at_hand_n - held.before_n, held.limits().slew_n_s * 0.002 + 0.001);
          zeroed += held.before_n > 0 && held.at_hand_n == 0 ? 1 : 0;
        }
      };
      watch(length_ms, false, writer_runs);
      watch(20 + random.below(1200), true, true);
      if (HasFatalFailure()) FAIL() << length_ms << " ms, writer " << writer_runs;
    }
  }
  EXPECT_GT(zeroed, 50);
}

}  // namespace
}  // namespace tactus::haptics
