#include "core/haptics/hid/hid_pid_device.h"

#include <chrono>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <thread>

#include "tests/core/haptics/hid/fake_transport.h"
#include "tests/core/haptics/loop_numbers.h"
#include "tests/support/real_time_trap.h"

namespace tactus::haptics {
namespace {

using support::PidModel;

const HidIdentity kIdentity{"hid:1209:ffb0:7", "Test board", "7"};

/// Whether `condition` comes true; the deadline only ends a test that hangs.
template <class Condition>
bool eventually(Condition condition) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(std::chrono::microseconds(50));
  }
  return true;
}

DeviceCalibration calibration() {
  DeviceCalibration c;
  c.device = kIdentity.id;
  c.serial = kIdentity.serial;
  c.full_scale_n = 10;
  c.mm_per_count = 0.01;
  c.friction_in_n = 0.1;
  c.inwards = {1, 0, 0};  // along the first motor, which all models have
  return c;
}

/// A device on a fake line. The clock of both is the line's and stands still unless a test moves it.
class HidPidDeviceTest : public testing::Test {
 protected:
  void open(PidModel model, std::optional<DeviceCalibration> with = calibration()) {
    line_ = std::make_shared<FakeLine>(model);
    HidPidTiming timing;
    timing.now_ns = [line = line_] { return line->now_ns.load(); };
    timing.pause = [](std::int64_t) { std::this_thread::sleep_for(std::chrono::microseconds(20)); };
    auto device = HidPidDevice::open(std::make_unique<FakeTransport>(line_), kIdentity, with, timing);
    ASSERT_TRUE(device) << device.error().message();
    device_ = *std::move(device);
  }
  void start(PidModel model, std::optional<DeviceCalibration> with = calibration()) {
    open(model, with);
    const auto started = device_->start();
    ASSERT_TRUE(started) << started.error().message();
  }
  std::int64_t now() const { return line_->now_ns; }
  /// One tick of a servo that asks for `force_n`.
  DeviceState tick(const Vector3& force_n) {
    line_->now_ns += kMs;
    const DeviceState state = device_->read(now());
    device_->write(force_n, now());
    return state;
  }
  std::array<double, 2> force() const { return line_->device().force(now()); }
  bool forceBecomes(double x) {
    return eventually([&] { return std::abs(force()[0] - x) < 1e-3; });
  }

  std::shared_ptr<FakeLine> line_;
  std::unique_ptr<HidPidDevice> device_;
};

TEST_F(HidPidDeviceTest, TellsWhatItIs) {
  open(PidModel::kBoard);
  const DeviceInfo& info = device_->info();
  EXPECT_EQ(info.id, "hid:1209:ffb0:7");
  EXPECT_EQ(info.backend, "hid-pid");
  EXPECT_FALSE(info.simulated);
  EXPECT_EQ(info.force_axes, 2);
  EXPECT_EQ(info.position_axes, 3);
  EXPECT_EQ(info.buttons, 32);
  EXPECT_EQ(info.max_force_n, 10);
  EXPECT_EQ(info.count_mm, 0.01);
  EXPECT_EQ(info.friction_in_n, 0.1);
  EXPECT_EQ(info.friction_out_n, std::nullopt);
  EXPECT_EQ(info.quiet_after_s, 0.1);
  EXPECT_EQ(info.hold_s, 0.04);
  open(PidModel::kWheel);
  EXPECT_EQ(device_->info().force_axes, 1);
  EXPECT_EQ(device_->info().position_axes, 1);
}

TEST_F(HidPidDeviceTest, PositionsComeInMillimetresInTheFrameOfThePerson) {
  start(PidModel::kSketch);
  EXPECT_EQ(device_->read(now()).number, 0U);
  line_->queue(line_->device().inputReport({300, -1200}, 2));
  ASSERT_TRUE(eventually([&] { return device_->read(now()).number == 1; }));
  const DeviceState state = device_->read(now());
  EXPECT_DOUBLE_EQ(state.position_mm.x, 3);
  EXPECT_DOUBLE_EQ(state.position_mm.y, 0);
  EXPECT_DOUBLE_EQ(state.position_mm.z, -12) << "HID's Y points to the person: away is into the patient";
  EXPECT_EQ(state.buttons, 2U);
  EXPECT_EQ(state.time_ns, now());
  EXPECT_EQ(state.fault, DeviceFault::kNone);
  EXPECT_FALSE(state.velocity_mm_s);
}

TEST_F(HidPidDeviceTest, OfManyWaitingReportsTheNewestCounts) {
  start(PidModel::kBoard);
  for (int i = 1; i <= 60; ++i) line_->queue(line_->device().inputReport({i, 0}, 0));
  ASSERT_TRUE(eventually([&] { return device_->read(now()).number == 60; }));
  EXPECT_DOUBLE_EQ(device_->read(now()).position_mm.x, 0.6);
  EXPECT_EQ(line_->unread(), 0U);
  EXPECT_EQ(device_->counters().reports, 60U);
}

TEST_F(HidPidDeviceTest, TheForceReachesEveryModelAndStopEndsIt) {
  for (const PidModel model : support::kPidModels) {
    start(model);
    const double sign = model == PidModel::kBoard ? -1 : 1;
    tick({2, 0, 0});
    EXPECT_TRUE(forceBecomes(sign * 0.2)) << name(model);
    tick({-1, 0, 0});
    EXPECT_TRUE(forceBecomes(-sign * 0.1)) << name(model);
    EXPECT_TRUE(eventually([&] { return device_->read(now()).written_ns == now(); }));
    device_->stop();
    EXPECT_EQ(force(), (std::array<double, 2>{}));
    EXPECT_FALSE(line_->device().actuatorsOn());
    EXPECT_EQ(line_->device().effectsInUse(), 0);
    EXPECT_EQ(line_->device().complaints(), std::vector<std::string>()) << name(model);
    device_->stop();
    ASSERT_TRUE(device_->start()) << "and again";
    tick({2, 0, 0});
    EXPECT_TRUE(forceBecomes(sign * 0.2)) << name(model);
  }
}

TEST_F(HidPidDeviceTest, TheDestructorStopsIt) {
  start(PidModel::kBoard);
  tick({2, 0, 0});
  ASSERT_TRUE(forceBecomes(-0.2));
  device_.reset();
  EXPECT_EQ(force(), (std::array<double, 2>{}));
  EXPECT_FALSE(line_->device().actuatorsOn());
}

TEST_F(HidPidDeviceTest, AStalledLineDoesNotHoldUpTheServo) {
  start(PidModel::kSketch);
  tick({1, 0, 0});
  ASSERT_TRUE(forceBecomes(0.1));
  line_->stall();
  ASSERT_TRUE(eventually([&] {
    tick({2, 0, 0});
    return line_->writeWaits();
  }));
  const std::int64_t written_before = device_->read(now()).written_ns;
  line_->forget();
  for (int i = 0; i < 200; ++i) tick({3, 0, 0});
  DeviceState state = tick({4, 0, 0});
  EXPECT_EQ(state.written_ns, written_before);
  EXPECT_GE(now() - state.written_ns, 200 * kMs) << "the age that the write watchdog sees";
  EXPECT_EQ(force(), (std::array<double, 2>{})) << "the effects ran out on the device";
  line_->resume();
  EXPECT_TRUE(forceBecomes(0.4)) << "the newest force";
  // What was asked for meanwhile was never sent: 3 N are 3000 of 10000.
  for (const Sent& sent : line_->sent()) EXPECT_NE(sent.report, (Bytes{5, 1, 0xB8, 0x0B}));
}

TEST_F(HidPidDeviceTest, StopDuringABlockedWriteLeavesTheDeviceQuiet) {
  start(PidModel::kSketch);
  tick({1, 0, 0});
  ASSERT_TRUE(forceBecomes(0.1));
  line_->stall();
  ASSERT_TRUE(eventually([&] {
    tick({2, 0, 0});
    return line_->writeWaits();
  }));
  line_->forget();
  std::atomic<bool> asked{false};
  std::thread stopping([&] {
    asked = true;
    device_->stop();
  });
  ASSERT_TRUE(eventually([&] { return asked.load(); }));
  for (int i = 0; i < 100; ++i) tick({5, 0, 0});
  EXPECT_EQ(force(), (std::array<double, 2>{})) << "even before anything gets through";
  line_->resume();
  stopping.join();
  EXPECT_EQ(force(), (std::array<double, 2>{}));
  EXPECT_FALSE(line_->device().actuatorsOn());
  EXPECT_EQ(line_->device().effectsInUse(), 0);
  for (const Sent& sent : line_->sent()) EXPECT_NE(sent.report, (Bytes{5, 1, 0x88, 0x13})) << "5 N after stop";
}

TEST_F(HidPidDeviceTest, StopGivesUpOnADeviceThatTakesNothing) {
  start(PidModel::kBoard);
  line_->writes_fail = true;
  tick({1, 0, 0});
  EXPECT_TRUE(eventually([&] { return device_->counters().failed_rounds > 0; }));
  device_->stop();
}

TEST_F(HidPidDeviceTest, AnUnpluggedDeviceIsLostAtOnce) {
  start(PidModel::kBoard);
  line_->queue(line_->device().inputReport({5, 5}, 0));
  ASSERT_TRUE(eventually([&] { return device_->read(now()).number == 1; }));
  EXPECT_EQ(device_->read(now()).fault, DeviceFault::kNone);
  line_->unplugged = true;
  line_->queue({});  // wakes the reader, as the kernel does
  EXPECT_TRUE(eventually([&] { return device_->read(now()).fault == DeviceFault::kLost; }));
  for (int i = 0; i < 10; ++i) EXPECT_EQ(tick({1, 0, 0}).fault, DeviceFault::kLost);
  device_->stop();
  EXPECT_FALSE(device_->start()) << "still unplugged";
}

TEST_F(HidPidDeviceTest, ASlowDeviceGetsTheNewestForce) {
  start(PidModel::kSketch);
  line_->write_takes_ns = 5 * kMs;
  for (int i = 1; i <= 300; ++i) tick({0.001 * i, 0, 0});
  ASSERT_TRUE(eventually([&] {
    device_->write({7, 0, 0}, now());
    return std::abs(force()[0] - 0.7) < 1e-3;
  }));
  EXPECT_GE(device_->counters().longest_round_ns, 5 * kMs);
}

TEST_F(HidPidDeviceTest, TheSwitchOfTheDeviceIsAFault) {
  start(PidModel::kBoard);
  line_->queue(line_->device().stateReport());
  line_->queue(line_->device().inputReport({1, 0}, 0));
  ASSERT_TRUE(eventually([&] { return device_->read(now()).number == 1; }));
  EXPECT_EQ(device_->read(now()).fault, DeviceFault::kNone);
  line_->with([&](support::FakePidDevice& device) { device.pressSafetySwitch(true, now()); });
  line_->queue(line_->device().stateReport());
  EXPECT_TRUE(eventually([&] { return device_->read(now()).fault == DeviceFault::kSwitchedOff; }));
}

/// Another program resets the device: our effects are gone, and the device says that nothing plays.
TEST_F(HidPidDeviceTest, AnEffectThatSomebodyElseStopsCountsAsSwitchedOff) {
  start(PidModel::kBoard);
  line_->queue(line_->device().inputReport({1, 0}, 0));
  line_->queue(line_->device().stateReport());
  ASSERT_TRUE(eventually([&] { return line_->unread() == 0 && device_->read(now()).number == 1; }));
  for (int i = 0; i < 100; ++i) {
    tick({1, 0, 0});
    line_->queue(line_->device().stateReport());
    ASSERT_TRUE(eventually([&] { return line_->unread() == 0; }));
    ASSERT_EQ(device_->read(now()).fault, DeviceFault::kNone) << i;
  }
  line_->with([&](support::FakePidDevice& device) {
    device.output(Bytes{0x0C, 8}, now());
    device.output(Bytes{0x0C, 1}, now());
  });
  line_->queue(line_->device().stateReport());
  int ticks = 0;
  // A start that the device does not know may be on its way for 20 ms; the clock moves a millisecond per tick.
  EXPECT_TRUE(eventually([&] {
    ++ticks;
    return tick({1, 0, 0}).fault == DeviceFault::kSwitchedOff;
  }));
  device_->stop();
  // Started again it has effects of its own, and forgets what it was told before.
  ASSERT_TRUE(device_->start());
  line_->queue(line_->device().inputReport({1, 0}, 0));
  line_->queue(line_->device().stateReport());
  ASSERT_TRUE(eventually([&] { return device_->read(now()).number == 1; }));
  EXPECT_EQ(device_->read(now()).fault, DeviceFault::kNone);
}

TEST_F(HidPidDeviceTest, ReportsFromBeforeTheStartAreDropped) {
  start(PidModel::kSketch);
  device_->stop();
  for (int x = 0; x < 100; ++x) line_->queue(line_->device().inputReport({x, 0}, 1));
  ASSERT_TRUE(device_->start());
  EXPECT_EQ(line_->unread(), 0U);
  line_->queue(line_->device().inputReport({500, 0}, 0));
  ASSERT_TRUE(eventually([&] { return device_->read(now()).number > 0; }));
  EXPECT_EQ(device_->read(now()).number, 1U);
  EXPECT_DOUBLE_EQ(device_->read(now()).position_mm.x, 5);
  EXPECT_EQ(device_->read(now()).buttons, 0U);
}

TEST_F(HidPidDeviceTest, WithoutACalibrationPositionsAreCountsAndTheStateSaysSo) {
  start(PidModel::kSketch, std::nullopt);
  EXPECT_EQ(device_->info().count_mm, std::nullopt);
  line_->queue(line_->device().inputReport({300, -1200}, 0));
  ASSERT_TRUE(eventually([&] { return device_->read(now()).number == 1; }));
  EXPECT_EQ(device_->read(now()).fault, DeviceFault::kNotCalibrated);
  EXPECT_EQ(device_->read(now()).position_mm, (Vector3{300, 0, -1200}));
  tick({0.05, 0, 0});
  EXPECT_TRUE(forceBecomes(0.05)) << "1 N is full scale";
}

TEST_F(HidPidDeviceTest, ASilentDeviceIsFreshWhileItTakesForces) {
  auto silent = calibration();
  silent.silent_when_still = true;
  start(PidModel::kBoard, silent);
  line_->queue(line_->device().inputReport({1, 0}, 0));
  ASSERT_TRUE(eventually([&] { return device_->read(now()).number == 1; }));
  for (int i = 0; i < 20; ++i) {
    tick({1, 0, 0});
    ASSERT_TRUE(eventually([&] { return device_->read(now()).time_ns == now(); })) << i;
  }
  EXPECT_EQ(device_->read(now()).number, 1U);
}

TEST_F(HidPidDeviceTest, AVocalDeviceThatFallsSilentGoesStale) {
  start(PidModel::kBoard);
  line_->queue(line_->device().inputReport({1, 0}, 0));
  ASSERT_TRUE(eventually([&] { return device_->read(now()).number == 1; }));
  const std::int64_t arrived = device_->read(now()).time_ns;
  for (int i = 0; i < 20; ++i) tick({1, 0, 0});
  EXPECT_TRUE(eventually([&] { return device_->read(now()).written_ns == now(); }));
  EXPECT_EQ(device_->read(now()).time_ns, arrived);
}

TEST_F(HidPidDeviceTest, ReadAndWriteKeepTheRulesOfTheServo) {
  start(PidModel::kBoard);
  line_->queue(line_->device().inputReport({1, 0}, 0));
  ASSERT_TRUE(eventually([&] { return device_->read(now()).number == 1; }));
  const std::int64_t at_ns = now();
  support::RealTimeTrap trap;
  for (int i = 0; i < 1000; ++i) {
    device_->read(at_ns);
    device_->write({1, 2, 3}, at_ns);
  }
  trap.disarm();
  EXPECT_EQ(trap.hits(), 0) << trap.first();
}

/// One motor, along x, and a path that leaves it by 20 degrees. A handle on this path feels of a push of the motor what
/// lies along the path: the cosine.
TEST_F(HidPidDeviceTest, ANewtonAskedForIsANewtonAlongAPathBesideTheMotor) {
  const double angle = 20 * std::numbers::pi / 180;
  auto beside = calibration();
  beside.inwards = {std::cos(angle), 0, -std::sin(angle)};
  start(PidModel::kWheel, beside);
  const AxisMapping axis = axisOf(beside);
  for (const double asked_n : {1.0, -1.0, 3.0}) {
    tick(axis.forceOnHand(asked_n));
    EXPECT_TRUE(eventually([&] {
      const double motor_n = 10 * force()[0];  // full scale is 10 N
      const double resistance_n = -motor_n * std::cos(angle);
      return std::abs(resistance_n - asked_n) < 2e-3;  // one step of 10,000 is 1 mN
    })) << asked_n
        << " N: " << -10 * force()[0] * std::cos(angle);
  }
  EXPECT_NEAR(device_->info().max_force_n, 10 * std::cos(angle), 1e-12) << "what the motor can do along the path";
}

TEST_F(HidPidDeviceTest, AnAxisThatIsTooFarOffTheMotorsIsRefused) {
  auto across = calibration();
  across.inwards = {0.6, 0, -0.8};
  auto line = std::make_shared<FakeLine>(PidModel::kWheel);
  EXPECT_EQ(HidPidDevice::open(std::make_unique<FakeTransport>(line), kIdentity, across).error().message(),
            "hid:1209:ffb0:7: insertion axis: found a cosine of 0.60 to the motors, wanted at least 0.9 (calibrate it "
            "again, along its motors)");
  open(PidModel::kBoard, across);  // its second motor is along z
  EXPECT_EQ(device_->info().max_force_n, 10);
}

TEST_F(HidPidDeviceTest, RefusesWhatItCannotUse) {
  auto line = std::make_shared<FakeLine>(PidModel::kBoard);
  auto nonsense = calibration();
  nonsense.full_scale_n = -1;
  EXPECT_EQ(HidPidDevice::open(std::make_unique<FakeTransport>(line), kIdentity, nonsense).error().message(),
            "full_scale_n: found -1, wanted a number from 0.05 to 500");
  start(PidModel::kBoard);
  device_->stop();
  line_->writes_fail = true;
  EXPECT_EQ(device_->start().error().message(), "hid:1209:ffb0:7: output report: found a broken line, wanted a device");
}

}  // namespace
}  // namespace tactus::haptics
