#include "core/haptics/simulated/virtual_device.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "core/haptics/device/device.h"

#include "tests/core/haptics/simulated/axis_mm.h"
#include "tests/core/haptics/simulated/virtual_clock.h"
#include "tests/support/real_time_trap.h"

namespace tactus::haptics {
namespace {

std::unique_ptr<VirtualDevice> started(VirtualDeviceSettings settings) {
  auto device = VirtualDevice::make(std::move(settings));
  EXPECT_TRUE(device) << device.error().message();
  EXPECT_TRUE((*device)->start());
  return std::move(*device);
}

VirtualDeviceSettings stroking() {
  VirtualDeviceSettings settings;
  settings.plan = strokes({.count = 5});
  return settings;
}

Vector3 against(double resistance_n) { return AxisMapping().forceOnHand(resistance_n); }

/// Everything a loop sees and does with a force that depends on what it saw.
std::vector<double> trace(VirtualDevice& device, int ticks) {
  std::vector<double> out;
  for (int i = 0; i < ticks; ++i) {
    const DeviceState state = device.read(tickNs(i));
    device.write(against(0.01 * axisMm(state)), tickNs(i));
    out.insert(out.end(), {axisMm(state), static_cast<double>(state.number), static_cast<double>(state.buttons),
                           device.truePositionMm(), device.trueSpeedMmS(), device.trueForceN()});
  }
  return out;
}

TEST(VirtualDevice, SaysWhatItIs) {
  VirtualDeviceSettings settings;
  settings.mechanics.damping_n_s_m = 0.7;
  settings.delay_s = 0.002;
  settings.count_mm = 0.02;
  const auto device = started(settings);
  EXPECT_TRUE(device->info().simulated);
  EXPECT_EQ(device->info().backend, "virtual");
  EXPECT_NE(device->info().name.find("simulated"), std::string::npos);
  EXPECT_NEAR(device->info().damping_n_s_mm, 0.0007, 1e-18);
  EXPECT_EQ(device->info().delay_s, 0.002);
  EXPECT_EQ(device->info().count_mm, 0.02);
  settings.count_mm = 0;
  EXPECT_FALSE(started(settings)->info().count_mm);
}

TEST(VirtualDevice, PositionsAreTheNearestCountAndSamplesAreNumbered) {
  const auto device = started(stroking());
  for (int i = 0; i < 2000; ++i) {
    const DeviceState state = device->read(tickNs(i));
    ASSERT_EQ(state.number, static_cast<std::uint64_t>(i) + 1);
    ASSERT_EQ(state.time_ns, tickNs(i));
    ASSERT_EQ(state.fault, DeviceFault::kNone);
    ASSERT_EQ(state.written_ns, 0);
    const double counts = axisMm(state) / 0.055;
    ASSERT_NEAR(counts, std::round(counts), 1e-12 * (1 + std::abs(counts)));
    ASSERT_LE(std::abs(axisMm(state) - device->truePositionMm()), 0.055 / 2 + 1e-12);
  }
}

TEST(VirtualDevice, LiesAlongItsAxis) {
  VirtualDeviceSettings settings = stroking();
  settings.inwards = {0.6, 0, -0.8};
  const auto tilted = started(settings);
  const auto straight = started(stroking());
  const AxisMapping axis = *AxisMapping::make(settings.inwards);
  for (int i = 0; i < 1000; ++i) {
    const DeviceState state = tilted->read(tickNs(i));
    ASSERT_NEAR(axis.positionMm(state.position_mm), axisMm(straight->read(tickNs(i))), 1e-12);
    ASSERT_NEAR(state.position_mm.x / 0.6, state.position_mm.z / -0.8, 1e-12);
    // What pulls across the axis does nothing.
    tilted->write({0.8, 0, 0.6}, tickNs(i));
  }
}

TEST(VirtualDevice, ForceActsAfterExactlyTheDelay) {
  for (const int delay : {0, 1, 2, 5, 100}) {
    VirtualDeviceSettings settings;
    settings.delay_s = 0.001 * delay;
    settings.quiet_after_s = 1;
    settings.plan = push(0);
    settings.mechanics.dry_friction_n = 0;
    const auto device = started(settings);
    for (int i = 0; i < 120; ++i) {
      const DeviceState state = device->read(tickNs(i));
      device->write(against(i < 7 ? 0 : 0.1 * i), tickNs(i));
      // Between the ticks i - 1 and i acted the force of tick i - 1 - delay.
      const int of = i - 1 - delay;
      ASSERT_EQ(device->trueForceN(), of < 7 ? 0 : std::min(0.1 * of, 3.3)) << i << ", delay " << delay;
      ASSERT_EQ(device->truePositionMm() < 0, of >= 7);
      ASSERT_EQ(state.written_ns, of < 0 ? 0 : tickNs(of + delay));
    }
  }
}

TEST(VirtualDevice, AConstantForceIsHeldAgainstByTheHand) {
  VirtualDeviceSettings settings;
  settings.plan = push(0);
  settings.mechanics.dry_friction_n = 0;
  const auto device = started(settings);
  for (int i = 0; i < 3000; ++i) {
    device->read(tickNs(i));
    device->write(against(0.4), tickNs(i));
  }
  EXPECT_NEAR(device->truePositionMm(), -4, 1e-6);  // 0.4 N on 100 N/m
}

TEST(VirtualDevice, SameRunSameBits) {
  VirtualDeviceSettings settings = stroking();
  settings.dropped_share = 0.01;
  settings.stalls_per_s = 3;
  settings.seed = 11;
  const auto one = started(settings);
  const auto first = trace(*one, 4000);
  EXPECT_EQ(first, trace(*started(settings), 4000));
  ASSERT_TRUE(one->start());
  EXPECT_EQ(first, trace(*one, 4000)) << "started anew";
  settings.seed = 12;
  EXPECT_NE(first, trace(*started(settings), 4000));
}

TEST(VirtualDevice, HowOftenItIsReadDoesNotMatter) {
  VirtualDeviceSettings settings = stroking();
  const auto slow = started(settings);
  const auto fast = started(settings);
  for (int i = 0; i < 1000; ++i) {
    slow->read(tickNs(i));
    if (i > 0) fast->read(tickNs(i) - 654'321);
    fast->read(tickNs(i));
    ASSERT_EQ(slow->truePositionMm(), fast->truePositionMm());
  }
}

TEST(VirtualDevice, DroppedSamplesLeaveTheOneBefore) {
  VirtualDeviceSettings settings = stroking();
  settings.dropped_share = 0.1;
  const auto device = started(settings);
  DeviceState before;
  int dropped = 0;
  for (int i = 0; i < 10000; ++i) {
    const DeviceState state = device->read(tickNs(i));
    const bool old = state.number == before.number;
    dropped += old ? 1 : 0;
    ASSERT_TRUE(old || state.time_ns == tickNs(i));
    if (old) {
      ASSERT_EQ(state.position_mm, before.position_mm);
    }
    if (old) {
      ASSERT_EQ(state.time_ns, before.time_ns);
    }
    before = state;
  }
  EXPECT_NEAR(dropped, 1000, 5 * 30);  // standard deviation of the binomial: sqrt(10000 0.1 0.9) = 30
}

TEST(VirtualDevice, StallsLastAsLongAsToldAndHoldForcesBack) {
  VirtualDeviceSettings settings = stroking();
  settings.stalls_per_s = 5;
  settings.shortest_stall_ms = 3;
  settings.longest_stall_ms = 9;
  const auto device = started(settings);
  DeviceState before;
  int length = 0;
  int stalls = 0;
  bool seen[64] = {};
  for (int i = 0; i < 20000; ++i) {
    const DeviceState state = device->read(tickNs(i));
    device->write(against(0.1 + 0.0001 * i), tickNs(i));
    if (state.number == before.number) {
      ++length;
      ASSERT_TRUE(length == 1 || state.written_ns == before.written_ns) << "no force reaches it";
    } else if (length > 0) {
      ++stalls;
      if (length < 64) seen[length] = true;
      length = 0;
    }
    before = state;
  }
  EXPECT_NEAR(stalls, 100, 50);  // Poisson, five standard deviations of 10; less where one begins within another
  EXPECT_FALSE(seen[1] || seen[2]);
  for (int ms = 3; ms <= 9; ++ms) EXPECT_TRUE(seen[ms]) << ms;
}

TEST(VirtualDevice, FaultsComeAndGoWhenTheScriptSays) {
  VirtualDeviceSettings settings = stroking();
  settings.faults = {{InjectedFault::kStalled, 0.2, 0.05},
                     {InjectedFault::kStuckValue, 0.3, 0.05},
                     {InjectedFault::kNotANumber, 0.4, 0.05},
                     {InjectedFault::kWarmMotors, 0.5, 0.05},
                     {InjectedFault::kUnplugged, 0.6, 0.05}};
  const auto device = started(settings);
  DeviceState before;
  for (int i = 0; i < 1000; ++i) {
    const DeviceState state = device->read(tickNs(i));
    device->write(against(0.2), tickNs(i));
    const auto during = [i](int from) { return i >= from && i < from + 50; };
    const bool fresh = !during(200) && !during(600);
    ASSERT_EQ(state.number != before.number, fresh) << i;
    ASSERT_EQ(std::isnan(state.position_mm.z), during(400)) << i;
    if (during(200) || during(300)) {
      ASSERT_EQ(state.position_mm, before.position_mm) << i;
    }
    ASSERT_EQ(state.fault, during(500)   ? DeviceFault::kWarmMotors
                           : during(600) ? DeviceFault::kLost
                                         : DeviceFault::kNone)
        << i;
    // One tick of delay, one more to have acted before a read; an unplugged device gives none from its tick on.
    ASSERT_EQ(device->trueForceN(), i < 2 || (i > 600 && i <= 650) ? 0 : 0.2) << i;
    before = state;
  }
}

TEST(VirtualDevice, SilentHostMeansNoForce) {
  VirtualDeviceSettings settings;
  settings.plan = push(0);
  const auto device = started(settings);
  device->read(tickNs(0));
  device->write(against(1), tickNs(0));
  for (int i = 1; i < 300; ++i) {
    device->read(tickNs(i));
    // It arrives at 1 ms and is forgotten 100 ms later.
    ASSERT_EQ(device->trueForceN(), i >= 2 && i <= 101 ? 1 : 0) << i;
  }
}

TEST(VirtualDevice, ForcesItCannotGiveAreCutAndReported) {
  VirtualDeviceSettings settings;
  settings.plan = push(0);
  const struct {
    double told_n;
    double given_n;
    DeviceFault fault;
  } cases[] = {{3.3, 3.3, DeviceFault::kNone},
               {3.4, 3.3, DeviceFault::kForceLimited},
               {-1e300, -3.3, DeviceFault::kForceLimited},
               {std::numeric_limits<double>::quiet_NaN(), 0, DeviceFault::kFailed},
               {std::numeric_limits<double>::infinity(), 0, DeviceFault::kFailed}};
  for (const auto& c : cases) {
    const auto device = started(settings);
    device->read(tickNs(0));
    device->write(against(c.told_n), tickNs(0));
    device->read(tickNs(1));
    EXPECT_EQ(device->read(tickNs(2)).fault, c.fault) << c.told_n;
    EXPECT_EQ(device->trueForceN(), c.given_n) << c.told_n;
    EXPECT_TRUE(std::isfinite(device->truePositionMm()));
    device->write(against(0.1), tickNs(2));
    device->read(tickNs(3));
    EXPECT_EQ(device->read(tickNs(4)).fault, DeviceFault::kNone);
  }
}

TEST(VirtualDevice, ALongPauseIsLeftOut) {
  VirtualDeviceSettings settings;
  settings.plan = push(100);
  const auto device = started(settings);
  int i = 0;
  for (; i < 500; ++i) {
    device->read(tickNs(i));
    device->write(against(0.3), tickNs(i));
  }
  const double before_mm = device->truePositionMm();
  i += 3'600'000;
  const DeviceState late = device->read(tickNs(i));
  EXPECT_EQ(late.time_ns, tickNs(i));
  EXPECT_EQ(device->trueForceN(), 0) << "no command for 250 ms";
  EXPECT_LE(device->truePositionMm() - before_mm, 25 + 5);   // a quarter of a second, and what 0.3 N had held back
  for (int k = 0; k < 1000; ++k) device->read(tickNs(++i));  // the hand rings out with exp(-5.9 t)
  const double then_mm = device->truePositionMm();
  for (int k = 0; k < 100; ++k) device->read(tickNs(++i));
  EXPECT_NEAR(device->truePositionMm() - then_mm, 10, 0.1) << "continues in step with the clock";
}

TEST(VirtualDevice, AClockThatGoesBackMovesNothing) {
  const auto device = started(stroking());
  for (int i = 0; i < 500; ++i) device->read(tickNs(i));
  const double before_mm = device->truePositionMm();
  device->read(tickNs(100));
  EXPECT_EQ(device->truePositionMm(), before_mm);
}

TEST(VirtualDevice, StoppedItGivesNoForceAndNothingMoves) {
  const auto device = started(stroking());
  trace(*device, 500);
  device->stop();
  const DeviceState state = device->read(tickNs(500));
  EXPECT_EQ(state.number, 500U);
  EXPECT_EQ(device->trueForceN(), 0);
  device->write(against(1), tickNs(500));
  EXPECT_EQ(device->read(tickNs(600)).position_mm, state.position_mm);
  device->stop();
}

TEST(VirtualDevice, LiveHandGoesWhereItIsTold) {
  const auto device = started({});
  device->setTarget(20);
  device->setButton(true);
  double fastest_mm_s = 0;
  for (int i = 0; i < 1500; ++i) {
    const DeviceState state = device->read(tickNs(i));
    fastest_mm_s = std::max(fastest_mm_s, std::abs(device->trueSpeedMmS()));
    ASSERT_EQ(state.buttons, i == 0 ? 0U : 1U) << "the hand decides once per millisecond, the first at the start";
  }
  EXPECT_NEAR(device->truePositionMm(), 20, 0.05 / 0.1);  // dry friction on the hand's spring
  // Below the outward guard of 400 mm/s, so that a jump of the mouse does not trip.
  EXPECT_LT(fastest_mm_s, 400);
  device->setTarget(-500);
  for (int i = 1500; i < 4500; ++i) {
    device->read(tickNs(i));
    ASSERT_GT(device->trueSpeedMmS(), -400);
  }
  EXPECT_NEAR(device->truePositionMm(), -500, 0.05 / 0.1);
}

TEST(VirtualDevice, LiveHandMayBeDrivenFromAnotherThread) {
  const auto device = started({});
  std::thread person([&] {
    for (int i = 1; i <= 1000; ++i) {
      device->setTarget(0.01 * i);
      device->setButton(true);
      EXPECT_TRUE(std::isfinite(device->truePositionMm()));
    }
  });
  for (int i = 0; i < 300; ++i) device->read(tickNs(i));
  person.join();
  for (int i = 300; i < 2000; ++i) device->read(tickNs(i));
  EXPECT_NEAR(device->truePositionMm(), 10, 0.05 / 0.1);
}

TEST(VirtualDevice, ReadAndWriteAreRealTimeSafe) {
  VirtualDeviceSettings settings;
  settings.plan = both(strokes({.count = 5}), swing(0.3, 10));
  settings.faults = {{InjectedFault::kStalled, 0.1, 0.3}};
  const auto scripted = started(settings);
  const auto live = started({});
  live->setTarget(30);
  for (VirtualDevice* device : {scripted.get(), live.get()}) {
    support::RealTimeTrap trap;
    for (int i = 0; i < 1000; ++i) {
      device->read(tickNs(i));
      device->write(against(0.2), tickNs(i));
    }
    trap.disarm();
    EXPECT_EQ(trap.hits(), 0) << trap.first();
  }
}

}  // namespace
}  // namespace tactus::haptics
