// A judgement counts for a force that was delivered: what the samples of a stimulus say of that.
#include "core/haptics/servo/stimulus_delivery.h"

#include <gtest/gtest.h>
#include <memory>
#include <optional>

#include "core/haptics/servo/servo_core.h"
#include "core/haptics/simulated/virtual_device.h"

#include "tests/core/haptics/loop_numbers.h"
#include "tests/core/haptics/safety/safety_loop.h"

namespace tactus::haptics {
namespace {

/// A stimulus told tick by tick.
class Told {
 public:
  void pass(int ticks, StimulusPhase phase, std::uint32_t limited = 0) {
    for (int i = 0; i < ticks; ++i) {
      Sample sample;
      sample.tick = ++tick_;
      sample.stimulus = phase;
      sample.limited = limited;
      delivery.add(sample);
    }
  }
  void lose(std::uint64_t ticks) { tick_ += ticks; }
  void rise() {
    pass(20, StimulusPhase::kWaiting, kLimitedByRelease);
    pass(150, StimulusPhase::kRising, kLimitedBySlew);
  }

  StimulusDelivery delivery;

 private:
  std::uint64_t tick_ = 40;
};

TEST(StimulusDelivery, IsGivenOnceTheFullForceWasReached) {
  Told told;
  EXPECT_FALSE(told.delivery.delivered());
  told.rise();
  EXPECT_FALSE(told.delivery.delivered()) << "the answer came before the full force";
  told.pass(5, StimulusPhase::kFull, kLimitedByFadeIn);
  EXPECT_FALSE(told.delivery.delivered()) << "armed a moment ago";
  told.pass(1, StimulusPhase::kFull);
  EXPECT_TRUE(told.delivery.delivered());
}

TEST(StimulusDelivery, EveryLimitThatKeepsTheForceFromTheHandVoidsIt) {
  for (const std::uint32_t limit :
       {kLimitedByGap, kLimitedByTrip, kLimitedByStaleDevice, kLimitedByGui, kLimitedByCap, kLimitedByThermal}) {
    Told told;
    told.rise();
    told.pass(300, StimulusPhase::kFull);
    told.pass(1, StimulusPhase::kFull, limit);
    told.pass(300, StimulusPhase::kFull);
    EXPECT_FALSE(told.delivery.delivered()) << limit;
    EXPECT_EQ(told.delivery.limits(), limit);
  }
}

TEST(StimulusDelivery, ATripThatEndsTheStimulusVoidsIt) {
  Told told;
  told.rise();
  told.pass(300, StimulusPhase::kFull);
  told.pass(1, StimulusPhase::kEnded, kLimitedByTrip | kLimitedByRelease);
  EXPECT_FALSE(told.delivery.delivered());
}

TEST(StimulusDelivery, WhatComesAfterItsEndConcernsItNoMore) {
  for (const auto end : {StimulusPhase::kFalling, StimulusPhase::kEnded}) {
    Told told;
    told.rise();
    told.pass(300, StimulusPhase::kFull);
    told.pass(1, end, kLimitedByRelease);
    told.lose(100);
    told.pass(100, StimulusPhase::kEnded, kLimitedByTrip | kLimitedByGui);
    EXPECT_TRUE(told.delivery.delivered());
  }
}

TEST(StimulusDelivery, LostSamplesVoidItUnlessItWaits) {
  Told told;
  told.pass(5, StimulusPhase::kWaiting);
  told.lose(3);
  told.rise();
  told.pass(10, StimulusPhase::kFull);
  EXPECT_TRUE(told.delivery.delivered());
  told.lose(1);
  told.pass(10, StimulusPhase::kFull);
  EXPECT_FALSE(told.delivery.delivered());
  EXPECT_TRUE(told.delivery.lostSamples());
}

/// Samples of 1.7 N at the full force, of which `force_n` was given.
Sample fullSample(std::uint64_t tick, double force_n, std::uint32_t limited = 0) {
  Sample sample;
  sample.tick = tick;
  sample.stimulus = StimulusPhase::kFull;
  sample.source_force_n = 1.7;
  sample.force_n = force_n;
  sample.limited = limited;
  return sample;
}

TEST(StimulusDelivery, KeepsTheLeastShareOfTheFullForce) {
  StimulusDelivery delivery;
  EXPECT_EQ(delivery.leastShare(), std::nullopt);
  delivery.add(fullSample(1, 0.5, kLimitedByFadeIn));
  EXPECT_EQ(delivery.leastShare(), std::nullopt) << "the fade-in is no part of it";
  delivery.add(fullSample(2, 1.7));
  EXPECT_EQ(delivery.leastShare(), 1);
  delivery.add(fullSample(3, 0.9, kLimitedByThermal));
  delivery.add(fullSample(4, 1.7));
  ASSERT_TRUE(delivery.leastShare());
  EXPECT_NEAR(*delivery.leastShare(), 0.9 / 1.7, 1e-12);
  EXPECT_FALSE(delivery.delivered());
  delivery.add(fullSample(6, 1.7));
  EXPECT_EQ(delivery.leastShare(), std::nullopt) << "a tick is missing";
}

TEST(StimulusDelivery, ATripLeavesNothingOfTheForceAndABlankIsGivenInFull) {
  StimulusDelivery delivery;
  delivery.add(fullSample(1, 1.7));
  Sample tripped = fullSample(2, 0, kLimitedByTrip);
  tripped.stimulus = StimulusPhase::kEnded;
  delivery.add(tripped);
  EXPECT_EQ(delivery.leastShare(), 0);
  StimulusDelivery blank;
  Sample none = fullSample(1, 0);
  none.source_force_n = 0;
  blank.add(none);
  EXPECT_EQ(blank.leastShare(), 1);
}

/// A held device that asks for 1.7 N, in simulated time; `stall_ms` without a tick in the middle of the full force.
bool deliveredWithAStallOf(int stall_ms) {
  VirtualDeviceSettings settings;
  settings.quiet_after_s = 0.05;
  settings.plan = pressing([](double) { return HandTarget{}; }, 0.02);
  const auto device = std::move(*VirtualDevice::make(settings));
  EXPECT_TRUE(device->start().has_value());
  ServoCore core(device->info());
  ServoOrders orders;
  orders.source = ForceSource::kStimulus;
  orders.armed = true;
  orders.stimulus.number = 1;
  orders.stimulus.force_n = 1.7;
  orders.limits = LimitSettings::forDevice(device->info());
  StimulusDelivery delivery;
  for (int i = 1; i <= 3000; ++i) {
    const DeviceState state = device->read(i * kTickNs);
    if (i > 1500 && i <= 1500 + stall_ms) continue;
    const Sample sample = core.tick({i * kTickNs, state, &orders, 1, false, false, i * kTickNs});
    device->write(core.deviceForce(sample), i * kTickNs);
    delivery.add(sample);
  }
  return delivery.delivered();
}

TEST(StimulusDelivery, AStallLongerThanTheDeviceHoldsACommandVoidsIt) {
  EXPECT_TRUE(deliveredWithAStallOf(0));
  EXPECT_TRUE(deliveredWithAStallOf(40));
  EXPECT_FALSE(deliveredWithAStallOf(70));
}

}  // namespace
}  // namespace tactus::haptics
