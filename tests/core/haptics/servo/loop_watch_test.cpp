#include <gtest/gtest.h>

#include "core/haptics/servo/loop_statistics.h"

namespace tactus::haptics {
namespace {

constexpr std::int64_t kLookNs = 16'000'000;

TEST(LoopWatch, SaysAfterASecondThatTheLoopIsGone) {
  LoopWatch watch;
  std::int64_t now_ns = 5'000'000'000;
  for (std::uint64_t ticks = 0; ticks < 500; ticks += 16, now_ns += kLookNs) ASSERT_FALSE(watch.look(ticks, now_ns));
  const std::int64_t last_ns = now_ns - kLookNs;
  Trip trip;
  for (; !trip; now_ns += kLookNs) trip = watch.look(496, now_ns);
  EXPECT_EQ(trip.cause, TripCause::kServoLate);
  EXPECT_NEAR(trip.value, 1.008, 0.01);
  EXPECT_NEAR(static_cast<double>(trip.time_ns - last_ns) * 1e-9, 1.008, 0.01);
  EXPECT_EQ(trip.limit, 1);
}

TEST(LoopWatch, AProgramThatStoodStillBlamesNoLoop) {
  LoopWatch watch;
  EXPECT_FALSE(watch.look(10, 0));
  EXPECT_FALSE(watch.look(10, 60'000'000'000)) << "a minute, looked at once";
  EXPECT_FALSE(watch.look(11, 60'016'000'000));
}

TEST(LoopWatch, ATickTakesItBack) {
  LoopWatch watch;
  std::int64_t now_ns = 0;
  for (int i = 0; i < 60; ++i) ASSERT_FALSE(watch.look(1, now_ns += kLookNs));
  ASSERT_FALSE(watch.look(2, now_ns += kLookNs));
  for (int i = 0; i < 60; ++i) ASSERT_FALSE(watch.look(2, now_ns += kLookNs));
}

}  // namespace
}  // namespace tactus::haptics
