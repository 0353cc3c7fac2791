// The servo around its core, in virtual time: a device that the test scripts, one tick per millisecond.
#include "core/haptics/servo/servo.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <memory>
#include <vector>

#include "tests/core/haptics/loop_numbers.h"
#include "tests/core/haptics/scripted_device.h"
#include "tests/support/ngt_model.h"

namespace tactus::haptics {
namespace {

class ServoInVirtualTime : public testing::Test {
 protected:
  /// Ticks, and gives the samples of these ticks.
  std::vector<Sample> run(int ticks) {
    std::vector<Sample> samples;
    Sample room;
    for (int i = 0; i < ticks; ++i) {
      now_ns_ += kTickNs;
      servo_.tick(now_ns_);
      for (const Sample& sample : servo_.drain({&room, 1})) {
        samples.push_back(sample);
        const Vector3 force = orders_.axis.forceOnHand(sample.force_n);
        EXPECT_EQ(device_.x_n, force.x);
        EXPECT_EQ(device_.y_n, force.y);
        EXPECT_EQ(device_.z_n, force.z);
      }
    }
    EXPECT_EQ(samples.size(), static_cast<std::size_t>(ticks));
    return samples;
  }

  /// A stimulus that the hand holds against, past the fade-in.
  void feelStimulus(double force_n) {
    orders_.source = ForceSource::kStimulus;
    orders_.armed = true;
    orders_.stimulus = {orders_.stimulus.number + 1, force_n, 0.15, {}, {}};
    servo_.post(orders_);
    run(50);
    device_.pressed = true;
    ASSERT_DOUBLE_EQ(run(1500).back().force_n, force_n);
  }

  std::int64_t now_ns_ = 5'000'000'000;
  ScriptedDevice device_;
  Servo servo_{device_};
  ServoOrders orders_;
};

TEST_F(ServoInVirtualTime, WithoutOrdersThereIsNoForce) {
  device_.pressed = true;
  device_.position_mm = 12.5;
  const auto samples = run(10);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    EXPECT_EQ(samples[i].tick, i + 1);
    EXPECT_EQ(samples[i].orders, 0U);
    EXPECT_EQ(samples[i].source, ForceSource::kOff);
    EXPECT_EQ(samples[i].force_n, 0);
    EXPECT_EQ(samples[i].position_mm, 12.5);
  }
  EXPECT_EQ(device_.writes, 10U) << "a zero is written, too";
}

TEST_F(ServoInVirtualTime, OrdersAreInForceAtTheNextTick) {
  for (std::uint64_t number = 1; number <= 50; ++number) {
    orders_.source = number % 2 == 0 ? ForceSource::kFree : ForceSource::kOff;
    ASSERT_EQ(servo_.post(orders_), number);
    const Sample sample = run(1).front();
    EXPECT_EQ(sample.orders, number);
    EXPECT_EQ(sample.source, orders_.source);
    run(static_cast<int>(number % 3));
  }
  const LoopStatistics seen = servo_.statistics();
  EXPECT_EQ(seen.orders_taken, 50U);
  EXPECT_EQ(seen.last_wait_ticks, 1U);
  EXPECT_EQ(seen.longest_wait_ticks, 1U);
}

TEST_F(ServoInVirtualTime, OfSeveralOrdersTheNewestCounts) {
  for (int i = 0; i < 5; ++i) servo_.post(orders_);
  orders_.source = ForceSource::kFree;
  servo_.post(orders_);
  const Sample sample = run(1).front();
  EXPECT_EQ(sample.orders, 6U);
  EXPECT_EQ(sample.source, ForceSource::kFree);
  EXPECT_EQ(servo_.statistics().orders_taken, 1U);
}

TEST_F(ServoInVirtualTime, AResistancePushesTheHandOutwards) {
  feelStimulus(0.5);
  EXPECT_EQ(device_.z_n, 0.5) << "toward the person";
  EXPECT_EQ(device_.x_n, 0);
}

TEST_F(ServoInVirtualTime, StopIsZeroAtTheNextTickAndLatched) {
  feelStimulus(0.5);
  servo_.stop();
  const auto samples = run(500);
  for (const Sample& sample : samples) {
    ASSERT_EQ(sample.force_n, 0) << "tick " << sample.tick;
    ASSERT_EQ(sample.trip, TripCause::kStopped);
  }
  const auto record = servo_.takeFlightRecord();
  ASSERT_TRUE(record.has_value());
  EXPECT_EQ(record->trip.cause, TripCause::kStopped);
  EXPECT_EQ(record->trip.time_ns, samples.front().time_ns);
  ASSERT_EQ(record->samples.size(), samples.front().tick + 200) << "all ticks before, and 200 after the trip's own";
  EXPECT_EQ(record->samples.front().tick, 1U);
  EXPECT_EQ(record->samples.back().tick, samples.front().tick + 200);
  EXPECT_EQ(record->samples[samples.front().tick - 2].force_n, 0.5);
  EXPECT_FALSE(servo_.takeFlightRecord().has_value());
}

TEST_F(ServoInVirtualTime, ArmingAgainAfterAStopGivesForcesAndAnotherRecord) {
  feelStimulus(0.5);
  servo_.stop();
  run(300);
  ASSERT_TRUE(servo_.takeFlightRecord().has_value());
  orders_.armed = false;
  servo_.post(orders_);
  device_.pressed = false;
  run(100);
  feelStimulus(0.4);
  servo_.stop();
  run(201);
  const auto record = servo_.takeFlightRecord();
  ASSERT_TRUE(record.has_value());
  EXPECT_EQ(record->trip.cause, TripCause::kStopped);
}

TEST_F(ServoInVirtualTime, AnotherAxisTurnsNoForceAround) {
  feelStimulus(0.8);
  orders_.axis = *AxisMapping::make({0, 0, 1});
  servo_.post(orders_);
  double before_n = 0.8;
  for (int i = 0; i < 200; ++i) {
    servo_.tick(now_ns_ += kTickNs);
    ASSERT_LE(device_.z_n, before_n);
    ASSERT_GE(device_.z_n, std::max(0.0, before_n - 0.5));
    before_n = device_.z_n;
  }
  EXPECT_EQ(device_.z_n, 0);
}

TEST_F(ServoInVirtualTime, LimitsThatLimitNothingAreABugOfThePoster) {
  orders_.limits.slew_n_s = std::numeric_limits<double>::quiet_NaN();
  EXPECT_DEATH(servo_.post(orders_), "wellFormed");
  orders_.limits = {};
  orders_.enable.press_debounce_s = -1;
  EXPECT_DEATH(servo_.post(orders_), "wellFormed");
}

TEST_F(ServoInVirtualTime, ThePedalReachesTheEnableSwitch) {
  orders_.source = ForceSource::kFree;
  orders_.armed = true;
  orders_.enable.kind = EnableKind::kPedal;
  servo_.post(orders_);
  EXPECT_FALSE(run(50).back().enabled);
  servo_.pedal(true);
  EXPECT_TRUE(run(50).back().enabled);
  servo_.pedal(false);
  EXPECT_FALSE(run(1).back().enabled) << "a release counts at once";
}

TEST_F(ServoInVirtualTime, ASilentProgramTakesTheForceAway) {
  feelStimulus(0.5);
  servo_.heartbeat(now_ns_);
  EXPECT_EQ(run(490).back().force_n, 0.5);
  const Sample silent = run(60).back();  // 0.55 s, of which 30 ms and more after the 0.5 s
  EXPECT_EQ(silent.force_n, 0);
  EXPECT_NE(silent.limited & kLimitedByGui, 0U);
}

TEST_F(ServoInVirtualTime, AgesAreOfTheSampleAndOfTheLastForce) {
  device_.age_ns = 300'000;
  run(10);
  const LoopStatistics seen = servo_.statistics();
  EXPECT_EQ(seen.ticks, 10U);
  EXPECT_EQ(seen.longest_gap_ns, kTickNs);
  EXPECT_EQ(seen.read_age.total(), 10U);
  EXPECT_EQ(seen.read_age.largest_ns, 300'000);
  EXPECT_EQ(seen.write_age.total(), 9U) << "at the first tick no force had been written";
  EXPECT_EQ(seen.write_age.largest_ns, kTickNs);
}

TEST_F(ServoInVirtualTime, ADeviceWithoutASampleHasNoReadAge) {
  device_.silent = true;
  run(10);
  EXPECT_EQ(servo_.statistics().read_age.total(), 0U);
}

TEST_F(ServoInVirtualTime, SamplesThatNobodyDrainsShowAsAJumpOfTicks) {
  const auto ticks = static_cast<int>(SampleRing::kDefaultCapacity) + 7;
  for (int i = 0; i < ticks; ++i) servo_.tick(now_ns_ += kTickNs);
  std::vector<Sample> room(SampleRing::kDefaultCapacity + 1);
  const auto drained = servo_.drain(room);
  ASSERT_EQ(drained.size(), SampleRing::kDefaultCapacity);
  EXPECT_EQ(drained.front().tick, 1U);
  const std::uint64_t last = drained.back().tick;
  servo_.tick(now_ns_ += kTickNs);
  EXPECT_EQ(servo_.drain(room).front().tick, last + 1 + 7);
}

TEST_F(ServoInVirtualTime, ReleaseWritesZeroAndIsNoGap) {
  feelStimulus(0.5);
  servo_.release(now_ns_);
  EXPECT_EQ(device_.z_n, 0);
  now_ns_ += 60 * kTickNs;
  servo_.tick(now_ns_);
  EXPECT_EQ(servo_.statistics().longest_gap_ns, kTickNs);
}

TEST_F(ServoInVirtualTime, ScenesAreFreedByWhoeverPosts) {
  const Conditions conditions{{"lubrication", 0.9}, {"neck_flexion", 45}};
  auto scene = ServoScene::make(support::s4FiveRegions(), conditions);
  ASSERT_TRUE(scene.has_value()) << scene.error().message();
  const std::weak_ptr<const ServoScene> first = *scene;
  orders_.source = ForceSource::kInsertion;
  orders_.scene = *scene;
  servo_.post(orders_);
  scene->reset();
  orders_.scene = nullptr;
  run(5);
  EXPECT_FALSE(first.expired()) << "in force";
  servo_.post(orders_);
  run(5);
  EXPECT_FALSE(first.expired()) << "the servo frees nothing";
  servo_.post(orders_);
  EXPECT_TRUE(first.expired());
}

TEST_F(ServoInVirtualTime, CountersOfTheSceneAreSeenFromOutside) {
  const auto scene = ServoScene::make(support::s4FiveRegions(), {{"lubrication", 0.9}, {"neck_flexion", 45}});
  ASSERT_TRUE(scene.has_value()) << scene.error().message();
  orders_.source = ForceSource::kInsertion;
  orders_.armed = true;
  orders_.scene = *scene;
  servo_.post(orders_);
  run(100);
  const render::SceneCounters seen = servo_.sceneCounters();
  EXPECT_EQ(seen.ticks, 100U);
  EXPECT_EQ(seen.released, 100U) << "the device is not held";
  EXPECT_EQ(seen.asked, 0U);
  EXPECT_EQ(servo_.thermalShare(), 0);
}

}  // namespace
}  // namespace tactus::haptics
