#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "core/base/random.h"
#include "core/haptics/safety/safety.h"

#include "tests/core/haptics/loop_numbers.h"

namespace tactus::haptics {
namespace {

/// One count between two medians that lie 10 ms apart; at the ends of a count twice half of it.
constexpr double kCountErrorMmS = kCountMm / 0.010;
/// While the window fills, and after a stall, the medians lie 5 ms apart or more.
constexpr double kShortCountErrorMmS = kCountMm / 0.005;

double counted(double position_mm) { return kCountMm * std::round(position_mm / kCountMm); }

/// A hand at one speed, sampled each millisecond.
class VelocityGuardTest : public testing::Test {
 protected:
  VelocityGuard guard_;
  LimitSettings limits_;
  double time_ms_ = 1000;
  double position_mm_ = 0;

  void sample(double position_mm) {
    guard_.add(++number_, static_cast<std::int64_t>(1e6 * time_ms_), counted(position_mm));
  }
  /// The device says that nothing has changed since the last sample.
  void renew(double after_ms) {
    guard_.add(number_, static_cast<std::int64_t>(1e6 * (time_ms_ + after_ms)), counted(position_mm_));
  }
  void move(double speed_mm_s, int ms) {
    for (int i = 0; i < ms; ++i) {
      time_ms_ += 1;
      position_mm_ += 1e-3 * speed_mm_s;
      sample(position_mm_);
    }
  }

 private:
  std::uint64_t number_ = 0;
};

TEST_F(VelocityGuardTest, MeasuresASteadySpeedToOneCountInTenMilliseconds) {
  for (const double speed_mm_s : {0.0, 5.0, 100.0, 257.0, -399.0, 599.0}) {
    move(speed_mm_s, 30);
    for (int i = 0; i < 200; ++i) {
      move(speed_mm_s, 1);
      ASSERT_NEAR(guard_.speedMmS(), speed_mm_s, kCountErrorMmS + 1e-9) << i;
    }
  }
}

TEST_F(VelocityGuardTest, TripsAtSixHundredInwardsAndFourHundredOutwards) {
  move(590, 500);
  EXPECT_FALSE(guard_.check(limits_));
  move(610, 40);
  EXPECT_EQ(guard_.check(limits_).cause, TripCause::kTooFastInwards);
  EXPECT_EQ(guard_.check(limits_).limit, 600);
  EXPECT_NEAR(guard_.check(limits_).value, 610, kCountErrorMmS);
  move(-390, 500);
  EXPECT_FALSE(guard_.check(limits_));
  move(-410, 40);
  EXPECT_EQ(guard_.check(limits_).cause, TripCause::kTooFastOutwards);
  EXPECT_NEAR(guard_.check(limits_).value, 410, kCountErrorMmS);
  limits_.guard_velocity = false;
  EXPECT_FALSE(guard_.check(limits_));
}

TEST_F(VelocityGuardTest, SeesASlipWithinFifteenMilliseconds) {
  move(0, 100);
  int ms = 0;
  for (; ms < 50 && !guard_.check(limits_); ++ms) move(-1000, 1);
  EXPECT_LE(ms, 15);
}

TEST_F(VelocityGuardTest, OneCountToAndFroIsNoSpeed) {
  for (int i = 0; i < 300; ++i) {
    time_ms_ += 1;
    sample(i % 2 == 0 ? 0 : kCountMm);
    ASSERT_LE(std::abs(guard_.speedMmS()), kShortCountErrorMmS + 1e-9);
  }
}

TEST_F(VelocityGuardTest, AWrongSampleOrTwoAreNoSpeed) {
  move(100, 50);
  for (const double wrong_mm : {40.0, -40.0}) {
    time_ms_ += 1;
    sample(position_mm_ + wrong_mm);
    for (int i = 0; i < 40; ++i) {
      move(100, 1);
      ASSERT_NEAR(guard_.speedMmS(), 100, 20) << i;
    }
  }
}

TEST_F(VelocityGuardTest, DroppedTicksStallsAndRepeatedSamplesAreNotSpeed) {
  base::Random random(7);
  std::uint64_t number = 0;
  for (const double speed_mm_s : {300.0, -300.0}) {
    guard_.forget();
    for (int i = 0; i < 20000; ++i) {
      const int stall_ms = random.below(100) == 0 ? 2 + random.below(48) : 1 + (random.below(10) == 0 ? 1 : 0);
      time_ms_ += stall_ms;
      position_mm_ += 1e-3 * speed_mm_s * stall_ms;
      const auto time_ns = static_cast<std::int64_t>(1e6 * time_ms_);
      ++number;
      for (int again = random.below(3); again >= 0; --again) guard_.add(number, time_ns, counted(position_mm_));
      if (i <= 20) continue;
      ASSERT_NEAR(guard_.speedMmS(), speed_mm_s, kShortCountErrorMmS + 1e-9) << i;
    }
  }
}

// A sample that a late thread took is stamped too late: up to 3 ms in the 10 ms between the medians would be 30 %; a
// median passes over one of them.
TEST_F(VelocityGuardTest, ALateStampIsNotSpeed) {
  base::Random random(8);
  for (int i = 0; i < 5000; ++i) {
    const double late_ms = random.below(20) == 0 ? random.uniform(0, 0.9) : 0;
    time_ms_ = 1000 + i + late_ms;
    sample(0.35 * i);
    if (i <= 20) continue;
    ASSERT_NEAR(guard_.speedMmS(), 350, 0.2 * 350) << i;
  }
}

TEST_F(VelocityGuardTest, ASampleThatIsOnlyRenewedIsAHandAtRest) {
  move(-500, 100);
  // Reports that come as late as the device sends them are no rest.
  renew(14.9);
  EXPECT_NEAR(guard_.speedMmS(), -500, kCountErrorMmS);
  renew(15.1);
  EXPECT_EQ(guard_.speedMmS(), 0);
  renew(10000);
  EXPECT_EQ(guard_.speedMmS(), 0);
  // A slip from there is seen as ever.
  time_ms_ += 10000;
  int ms = 0;
  for (; ms < 50 && !guard_.check(limits_); ++ms) move(-1000, 1);
  EXPECT_LE(ms, 15);
}

TEST_F(VelocityGuardTest, AStallIsNoRest) {
  move(-350, 100);
  time_ms_ += 49;
  position_mm_ -= 49 * 0.350;
  EXPECT_NEAR(guard_.speedMmS(), -350, kCountErrorMmS);  // there is nothing better
  for (int i = 0; i < 30; ++i) {
    move(-350, 1);
    ASSERT_NEAR(guard_.speedMmS(), -350, kShortCountErrorMmS);
  }
}

TEST_F(VelocityGuardTest, AFastDeviceFillsTheSameWindow) {
  for (int i = 0; i < 4000; ++i) {
    time_ms_ += 0.125;
    position_mm_ += 0.125e-3 * 200;
    sample(position_mm_);
    if (i <= 200) continue;
    ASSERT_NEAR(guard_.speedMmS(), 200, kCountErrorMmS + 1e-9);
  }
}

TEST_F(VelocityGuardTest, AClockOfAnotherDeviceStartsAnew) {
  move(500, 100);
  time_ms_ = 5;
  position_mm_ = -300;
  move(0, 1);
  EXPECT_EQ(guard_.speedMmS(), 0);
  move(0, 30);
  EXPECT_EQ(guard_.speedMmS(), 0);
}

}  // namespace
}  // namespace tactus::haptics
