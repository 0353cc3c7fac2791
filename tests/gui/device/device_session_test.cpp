#include "app/workbench/device/device_session.h"

#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <atomic>
#include <gtest/gtest.h>
#include <memory>
#include <utility>
#include <vector>

#include "app/workbench/device/device_search.h"
#include "core/haptics/sources/servo_scene.h"

#include "tests/gui/patience.h"
#include "tests/gui/sample_models.h"
#include "tests/gui/stepped_feel.h"

namespace tactus::workbench {
namespace {

using State = DeviceSession::State;

using tests::kPatience;
// The stimulus is constant: what the limits add is rounding.
constexpr double kRounding = 1e-9;
const QString kVirtual = QStringLiteral("virtual");

ForceOrders stimulus(double force_n, std::optional<double> hold_s = {}) {
  ForceOrders force;
  force.source = haptics::ForceSource::kStimulus;
  force.stimulus.number = 1;
  force.stimulus.force_n = force_n;
  force.stimulus.hold_limit_s = hold_s;
  return force;
}

haptics::VirtualDeviceSettings withFault(haptics::InjectedFault fault, double start_s, double duration_s) {
  haptics::VirtualDeviceSettings device;
  device.faults = {{fault, start_s, duration_s}};
  return device;
}

class DeviceSessionTest : public testing::Test {
 protected:
  DeviceSessionTest() {
    QObject::connect(&session, &DeviceSession::sampled, &session, [this](std::span<const haptics::Sample> samples) {
      felt.insert(felt.end(), samples.begin(), samples.end());
    });
  }

  // The hand has to be seen open once; the fade-in of the arming is over afterwards.
  void hold() {
    time.advance(session, 20);
    session.setHeld(true);
    time.advance(session, 1200);
  }

  double largestN() const {
    double largest_n = 0;
    for (const haptics::Sample& sample : felt) largest_n = std::max(largest_n, sample.force_n);
    return largest_n;
  }

  std::vector<haptics::Sample> felt;
  tests::SteppedFeel time;
  DeviceSession session{time.settings()};
};

TEST_F(DeviceSessionTest, StartsADeviceThatWasFoundWithoutAModel) {
  DeviceSearch search;
  const QSignalSpy found(&search, &DeviceSearch::found);
  search.search();
  ASSERT_TRUE(QTest::qWaitFor([&] { return found.count() == 1; }, kPatience));
  const std::string id = search.list().devices.back().id;

  EXPECT_EQ(session.state(), State::kStopped);
  session.start(QString::fromStdString(id));
  ASSERT_EQ(session.state(), State::kRunning);
  EXPECT_TRUE(session.device()->simulated);
  hold();
  time.moveTo(session, 5, 20);
  EXPECT_EQ(felt.size(), session.latest().tick) << "every sample, once";
  EXPECT_TRUE(session.latest().enabled);
  EXPECT_GT(session.latest().position_mm, 4);  // the device's own friction holds a soft hand back
  EXPECT_EQ(largestN(), 0) << "no source, no force";
  session.stop();
  EXPECT_EQ(session.state(), State::kStopped);
  EXPECT_FALSE(session.device());
}

TEST_F(DeviceSessionTest, AStimulusRisesAndFalls) {
  session.start(kVirtual);
  hold();
  EXPECT_TRUE(session.setForce(stimulus(0.5, 1.0)));
  time.advance(session, 75);  // half of the ramp of 0.15 s
  EXPECT_EQ(session.latest().stimulus, haptics::StimulusPhase::kRising);
  EXPECT_NEAR(session.latest().force_n, 0.25, 0.5 / 150 * 2);  // two ticks of the ramp
  time.advance(session, 100);
  EXPECT_EQ(session.latest().stimulus, haptics::StimulusPhase::kFull);
  EXPECT_NEAR(session.latest().force_n, 0.5, kRounding);
  time.advance(session, 1200);
  EXPECT_EQ(session.latest().stimulus, haptics::StimulusPhase::kEnded);
  EXPECT_EQ(session.latest().force_n, 0);
  EXPECT_NEAR(largestN(), 0.5, kRounding);
}

TEST_F(DeviceSessionTest, ADeviceCanStartWithAStimulus) {
  session.start(kVirtual, stimulus(0.4));
  hold();
  EXPECT_NEAR(session.latest().force_n, 0.4, kRounding);
  // Another number is another stimulus; the source `kFree` ends it.
  ForceOrders stronger = stimulus(0.6);
  stronger.stimulus.number = 2;
  session.setForce(stronger);
  time.advance(session, 300);
  EXPECT_NEAR(session.latest().force_n, 0.6, kRounding);
  session.setForce({});
  time.advance(session, 50);
  EXPECT_EQ(session.latest().force_n, 0);
}

TEST_F(DeviceSessionTest, ADeviceCanStartWithAScene) {
  const auto scene = haptics::ServoScene::make(tests::twoExperts(), {});
  ASSERT_TRUE(scene) << scene.error().message();
  ForceOrders force;
  force.source = haptics::ForceSource::kInsertion;
  force.scene = *scene;
  force.placement = 1;
  session.start(kVirtual, force);
  hold();
  time.moveTo(session, 5, 5);
  EXPECT_GT(session.latest().force_n, 0.1);
  // Another placement: the tube is out.
  const double depth_mm = session.latest().depth_mm;
  ASSERT_GT(depth_mm, 1);
  ++force.placement;
  const auto orders = session.setForce(force);
  time.advance(session, 2);
  EXPECT_GE(session.latest().orders, *orders);
  EXPECT_LT(session.latest().depth_mm, 0.1);
}

TEST_F(DeviceSessionTest, StopGivesZeroAndTheLastSamples) {
  session.start(kVirtual, stimulus(0.5));
  hold();
  ASSERT_GT(session.latest().force_n, 0);
  std::size_t at_end = 0;
  QObject::connect(&session, &DeviceSession::ending, &session, [&] {
    at_end = felt.size();
    EXPECT_TRUE(session.device()) << "the device can still be asked";
  });
  time.hang(10);
  session.stop();
  EXPECT_EQ(session.latest().force_n, 0);
  EXPECT_EQ(at_end, time.ticks());
  EXPECT_EQ(felt.size(), at_end);
  EXPECT_FALSE(session.setForce(stimulus(0.5))) << "nothing is in force without a run";
}

TEST_F(DeviceSessionTest, RefusesWhatDoesNotOpen) {
  DeviceAccess access = time.settings();
  access.open_device = [](const std::string&) -> base::Result<devices::OpenedDevice> {
    return base::fail(base::ErrorCode::kIo, "device", "not there", "a device");
  };
  DeviceSession none(access);
  const QSignalSpy failed(&none, &DeviceSession::failed);
  none.start(kVirtual);
  EXPECT_EQ(none.state(), State::kStopped);
  EXPECT_EQ(failed.count(), 1);
}

TEST(DeviceTripTest, SaysItsCauseAndArmsAgainOnceTheHandHasLetGo) {
  tests::SteppedFeel time(withFault(haptics::InjectedFault::kStalled, 0.5, 0.3));
  DeviceSession session(time.settings());
  session.start(kVirtual, stimulus(0.3));
  time.advance(session, 20);
  session.setHeld(true);
  time.advance(session, 1100);
  ASSERT_EQ(session.state(), State::kTripped);
  ASSERT_TRUE(session.trip());
  const std::string sentence = session.trip()->sentence.toStdString();
  EXPECT_TRUE(sentence.ends_with("s, allowed 0.050 s")) << sentence;
  EXPECT_EQ(session.latest().force_n, 0);

  session.rearm();
  time.advance(session, 100);
  EXPECT_EQ(session.state(), State::kRearming) << "the hand still holds";
  session.setHeld(false);
  time.advance(session, 100);
  EXPECT_EQ(session.state(), State::kRunning);
  EXPECT_FALSE(session.trip());
  ForceOrders again = stimulus(0.3);
  again.stimulus.number = 2;
  session.setForce(again);
  session.setHeld(true);
  time.advance(session, 1200);
  EXPECT_NEAR(session.latest().force_n, 0.3, kRounding);
}

TEST(DeviceTripTest, AnUnpluggedDeviceIsToldInWords) {
  tests::SteppedFeel time(withFault(haptics::InjectedFault::kUnplugged, 0.5, 1e6));
  DeviceSession session(time.settings());
  session.start(kVirtual, stimulus(0.3));
  time.advance(session, 20);
  session.setHeld(true);
  time.advance(session, 1100);
  EXPECT_EQ(session.state(), State::kTripped);
  ASSERT_TRUE(session.trip());
  EXPECT_EQ(session.trip()->sentence.toStdString(), "The device is gone");
  EXPECT_EQ(session.latest().force_n, 0);
  session.stop();
  EXPECT_EQ(session.state(), State::kStopped);
  EXPECT_TRUE(session.trip()) << "the cause stays said until the next start";
}

TEST_F(DeviceSessionTest, ALoopThatNobodyCallsEndsTheRun) {
  session.start(kVirtual);
  hold();
  const QSignalSpy failed(&session, &DeviceSession::failed);
  time.stall(session, 1100);
  EXPECT_EQ(session.state(), State::kStopped);
  ASSERT_EQ(failed.count(), 1);
  EXPECT_TRUE(failed[0][0].toString().startsWith(QStringLiteral("The loop of the device's driver has ended")));
}

class SlowDeviceTest : public testing::Test {
 protected:
  void let(bool go) {
    lets_go.store(go);
    lets_go.notify_all();
  }
  bool comes(State state) {
    return QTest::qWaitFor([&] { return session.state() == state; }, kPatience);
  }

  std::atomic<bool> lets_go{false};
  tests::SteppedFeel time;
  DeviceSession session{time.slowSettings(lets_go)};
};

TEST_F(SlowDeviceTest, AStartIsCanceled) {
  session.start(kVirtual);
  EXPECT_EQ(session.state(), State::kOpening);
  session.stop();
  EXPECT_EQ(session.state(), State::kStopping) << "the call has come back while the device still starts";
  let(true);
  ASSERT_TRUE(comes(State::kStopped));
  EXPECT_EQ(session.runs(), 0u);
  EXPECT_EQ(time.loops(), 0);
  session.start(kVirtual);
  EXPECT_TRUE(comes(State::kRunning));
}

TEST_F(SlowDeviceTest, StopsWithoutBlockingTheWindow) {
  let(true);
  session.start(kVirtual, stimulus(0.5));
  ASSERT_TRUE(comes(State::kRunning));
  time.advance(session, 50);
  let(false);
  session.stop();
  EXPECT_EQ(session.state(), State::kStopping) << "the call has come back while the device still stops";
  EXPECT_EQ(session.latest().force_n, 0);
  const QSignalSpy failed(&session, &DeviceSession::failed);
  session.start(kVirtual);
  EXPECT_EQ(failed.count(), 1) << "one at a time";
  let(true);
  EXPECT_TRUE(comes(State::kStopped));
}

TEST_F(SlowDeviceTest, WhatIsOrderedWhileItStartsCounts) {
  session.start(kVirtual);
  session.setGrip({true, -20});
  EXPECT_FALSE(session.setForce(stimulus(0.5))) << "not in force yet";
  let(true);
  ASSERT_TRUE(comes(State::kRunning));
  time.advance(session, 50);
  session.setHeld(true);
  time.advance(session, 50);
  session.setHeld(false);
  time.advance(session, 1200);
  EXPECT_TRUE(session.latest().enabled) << "a latch";
  EXPECT_NEAR(session.latest().force_n, 0.5, kRounding);
}

}  // namespace
}  // namespace tactus::workbench
