// The servo on a real thread. Nothing here depends on how fast the machine is: the tests wait until something is so.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <gtest/gtest.h>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/haptics/servo/servo.h"

#include "tests/core/haptics/scripted_device.h"
#include "tests/support/comes_true.h"
#include "tests/support/ngt_model.h"

namespace tactus::haptics {
namespace {

using support::comesTrue;

/// Locked memory would hold for the rest of the test program.
ServoThreadSettings settings() {
  ServoThreadSettings settings;
  settings.real_time.lock_memory = false;
  return settings;
}

ServoOrders stimulusOrders() {
  ServoOrders orders;
  orders.source = ForceSource::kStimulus;
  orders.armed = true;
  orders.stimulus = {1, 0.5, 0.15, {}, {}};
  return orders;
}

TEST(NextDue, IsAPeriodLaterOnTheSameGrid) {
  EXPECT_EQ(nextDueNs(10'000'000, 10'000'050, 1'000'000), 11'000'000);
  EXPECT_EQ(nextDueNs(10'000'000, 13'200'000, 1'000'000), 11'000'000) << "catches up";
  EXPECT_EQ(nextDueNs(10'000'000, 15'000'000, 1'000'000), 11'000'000) << "five periods late";
}

TEST(NextDue, IsRebasedAfterMoreThanFivePeriods) {
  EXPECT_EQ(nextDueNs(10'000'000, 15'000'001, 1'000'000), 16'000'001);
  EXPECT_EQ(nextDueNs(10'000'000, 900'000'000, 1'000'000), 901'000'000);
}

TEST(ServoThread, TicksUntilItIsStopped) {
  ScriptedDevice device;
  Servo servo(device);
  ServoThread thread(servo, settings());
  EXPECT_FALSE(thread.state().running);
  ASSERT_TRUE(thread.start().has_value());
  EXPECT_TRUE(thread.state().running);
  EXPECT_FALSE(thread.state().own_loop);
  ASSERT_TRUE(thread.start().has_value()) << "it runs already";
  EXPECT_TRUE(comesTrue([&] { return servo.ticks() > 20; }));
  thread.stop();
  thread.stop();
  EXPECT_FALSE(thread.state().running);
  const std::uint64_t ticks = servo.ticks();
  const LoopStatistics seen = servo.statistics();
  EXPECT_EQ(seen.ticks, ticks);
  EXPECT_EQ(seen.lateness.total(), ticks);
  EXPECT_EQ(seen.tick_duration.total(), ticks);
  EXPECT_EQ(device.writes, ticks + 1) << "one for each tick, and the zero at the end";
  ASSERT_TRUE(thread.start().has_value());
  EXPECT_TRUE(comesTrue([&] { return servo.ticks() > ticks + 5; })) << "starts again";
}

TEST(ServoThread, SaysWhatTheSystemPermitted) {
  ScriptedDevice device;
  Servo servo(device);
  ServoThread thread(servo, settings());
  ASSERT_TRUE(thread.start().has_value());
  const RealTime& real_time = thread.state().real_time;
  EXPECT_EQ(real_time.priority == 0, !real_time.priority_refused.empty());
  EXPECT_TRUE(real_time.fine_timer);
  EXPECT_FALSE(real_time.memory_locked) << "not asked for";
  EXPECT_TRUE(real_time.lock_refused.empty());
}

TEST(ServoThread, LeavesTheDeviceWithoutForce) {
  ScriptedDevice device;
  device.pressed = true;
  device.released_samples = 30;
  Servo servo(device);
  servo.post(stimulusOrders());
  {
    ServoThread thread(servo, settings());
    ASSERT_TRUE(thread.start().has_value());
    ASSERT_TRUE(comesTrue([&] { return device.z_n > 0; }));
  }
  EXPECT_EQ(device.z_n, 0);
}

TEST(ServoThread, AModelEditedLiveIsInForceWithinTwoTicks) {
  constexpr int kEdits = 200;
  ScriptedDevice device;
  Servo servo(device);
  ServoThread thread(servo, settings());
  ASSERT_TRUE(thread.start().has_value());

  fuzzy::ForceModel model = support::s4FiveRegions();
  std::vector<Sample> room(4096);
  std::uint64_t longest = 0, within_one = 0, last_tick = 0, lost = 0;
  for (int edit = 0; edit < kEdits; ++edit) {
    model.output.terms[0].points[3] = 0.2 + 0.0001 * edit;  // the end of "very small"
    const auto scene = ServoScene::make(model, {{"lubrication", 0.9}, {"neck_flexion", 45}});
    ASSERT_TRUE(scene.has_value()) << scene.error().message();
    ServoOrders orders;
    orders.source = ForceSource::kInsertion;
    orders.scene = *scene;
    // Everywhere between two ticks, and into them.
    const std::int64_t post_ns = monotonicNs() + edit * 7919 % 1000 * 1000;
    while (monotonicNs() < post_ns) std::this_thread::yield();
    const std::uint64_t number = servo.post(orders);
    // Ticks begun once the hand-over was complete: of those that begin later, the first has to use it.
    const std::uint64_t begun = servo.ticks();
    std::uint64_t first_tick = 0;
    ASSERT_TRUE(comesTrue([&] {
      for (const Sample& sample : servo.drain(room)) {
        if (sample.orders == number && first_tick == 0) first_tick = sample.tick;
        if (sample.tick != last_tick + 1) ++lost;
        last_tick = sample.tick;
      }
      return first_tick > 0;
    })) << "edit "
        << edit;
    const std::uint64_t waited = first_tick > begun ? first_tick - begun : 0;
    longest = std::max(longest, waited);
    if (waited <= 1) ++within_one;
  }
  EXPECT_LE(longest, 2U);
  EXPECT_EQ(lost, 0U);
  const LoopStatistics seen = servo.statistics();
  EXPECT_EQ(seen.orders_taken, static_cast<std::uint64_t>(kEdits));
  RecordProperty("edits", kEdits);
  RecordProperty("priority", thread.state().real_time.priority);
  RecordProperty("p99_lateness_ns", std::to_string(seen.lateness.quantileNs(0.99)));
  RecordProperty("p99_tick_ns", std::to_string(seen.tick_duration.quantileNs(0.99)));
  RecordProperty("longest_wait_ticks", static_cast<int>(longest));
  RecordProperty("edits_within_one_tick", static_cast<int>(within_one));
  RecordProperty("longest_wait_ticks_with_post", static_cast<int>(seen.longest_wait_ticks));
}

/// A model of one rule that fires everywhere: with scaled terms its force is the centroid of the one term, `force_n`.
fuzzy::ForceModel constantForce(double force_n) {
  fuzzy::ForceModel model;
  model.inputs = {{"depth", "Depth", "mm", 0, 1e5, {{"any", "Any", fuzzy::Shape::kTrapezoid, {0, 0, 1e5, 1e5}}}}};
  model.output = {"force", "Force",
                  "N",     0,
                  2,       {{"this", "This", fuzzy::Shape::kTriangle, {force_n - 0.1, force_n, force_n + 0.1}}}};
  model.implication = fuzzy::Implication::kScale;
  fuzzy::Expert expert;
  expert.id = "E1";
  expert.rules = {{{{"depth", "any"}}, "this"}};
  model.experts = {expert};
  return model;
}

TEST(ServoThread, TheForceBecomesThatOfAModelEditedLive) {
  ScriptedDevice device;
  device.pressed = true;
  device.released_samples = 30;
  device.mm_per_sample = 0.05;
  Servo servo(device);
  ServoThread thread(servo, settings());
  ServoOrders orders;
  orders.source = ForceSource::kInsertion;
  orders.armed = true;
  // On a machine that is busy elsewhere these would trip, rightly.
  orders.limits.guard_velocity = false;
  orders.limits.servo_trip_s = 1e6;
  ASSERT_TRUE(thread.start().has_value());
  std::vector<Sample> room(4096);
  for (const double force_n : {0.2, 0.6, 0.3, 0.7, 0.25, 0.5}) {
    const auto scene = ServoScene::make(constantForce(force_n), {});
    ASSERT_TRUE(scene.has_value()) << scene.error().message();
    orders.scene = *scene;
    const std::uint64_t number = servo.post(orders);
    Sample last;
    ASSERT_TRUE(comesTrue([&] {
      for (const Sample& sample : servo.drain(room)) last = sample;
      // To rounding of the centroid.
      return last.orders == number && std::abs(last.model_force_n - force_n) < 1e-12;
    })) << force_n
        << ", but the force was " << last.model_force_n << ", trip: " << describe(last.trip);
  }
}

TEST(ServoThread, StopFromAnotherThreadIsSeenInTheSamples) {
  ScriptedDevice device;
  device.pressed = true;
  device.released_samples = 30;
  Servo servo(device);
  servo.post(stimulusOrders());
  ServoThread thread(servo, settings());
  ASSERT_TRUE(thread.start().has_value());
  ASSERT_TRUE(comesTrue([&] { return device.z_n > 0; }));
  servo.stop();
  ASSERT_TRUE(comesTrue([&] { return device.z_n == 0; }));
  std::optional<FlightRecord> record;
  ASSERT_TRUE(comesTrue([&] {
    record = servo.takeFlightRecord();
    return record.has_value();
  }));
  EXPECT_EQ(record->trip.cause, TripCause::kStopped);
}

/// A driver with a servo thread of its own.
class DriverLoop final : public DeviceLoop {
 public:
  explicit DriverLoop(ScriptedDevice& device) : device_(device) { device.own_loop = this; }
  ~DriverLoop() override { end(); }
  base::Result<void> run(Ticked& ticked) override {
    if (broken) return base::fail(base::ErrorCode::kIo, "driver", "no answer", "an answer");
    ending_ = false;
    thread_ = std::thread([this, &ticked] {
      while (!ending_) {
        ticked.tick(monotonicNs());
        std::this_thread::yield();
      }
      device_.write({}, monotonicNs());
    });
    return {};
  }
  void end() noexcept override {
    ending_ = true;
    if (thread_.joinable()) thread_.join();
  }

  bool broken = false;

 private:
  ScriptedDevice& device_;
  std::atomic<bool> ending_{false};
  std::thread thread_;
};

TEST(ServoThread, LetsADriverCallThatHasALoopOfItsOwn) {
  ScriptedDevice device;
  DriverLoop loop(device);
  device.pressed = true;
  device.released_samples = 30;
  Servo servo(device);
  servo.post(stimulusOrders());
  ServoThread thread(servo, settings());
  ASSERT_TRUE(thread.start().has_value());
  EXPECT_TRUE(thread.state().own_loop);
  EXPECT_TRUE(comesTrue([&] { return device.z_n > 0; }));
  thread.stop();
  EXPECT_EQ(device.z_n, 0);
  const LoopStatistics seen = servo.statistics();
  EXPECT_EQ(seen.tick_duration.total(), seen.ticks);
}

TEST(ServoThread, TellsWhyADriversLoopDoesNotStart) {
  ScriptedDevice device;
  DriverLoop loop(device);
  loop.broken = true;
  Servo servo(device);
  ServoThread thread(servo, settings());
  const auto started = thread.start();
  ASSERT_FALSE(started.has_value());
  EXPECT_EQ(started.error().found, "no answer");
  EXPECT_FALSE(thread.state().running);
  thread.stop();
  EXPECT_EQ(servo.ticks(), 0U);
}

}  // namespace
}  // namespace tactus::haptics
