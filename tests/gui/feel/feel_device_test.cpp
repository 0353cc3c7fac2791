#include <QSignalSpy>
#include <QTest>
#include <atomic>
#include <gtest/gtest.h>
#include <thread>

#include "tests/gui/feel/feel_test.h"

namespace tactus::workbench {
namespace {

using tests::kPatience;

class FeelDeviceTest : public FeelTest {};

TEST_F(FeelDeviceTest, ASlowDeviceStartsAndStopsInTheBackground) {
  std::atomic<bool> lets_go{false};
  const auto let = [&lets_go] {
    lets_go.store(true);
    lets_go.notify_all();
  };
  DeviceSession slow_device{time.slowSettings(lets_go)};
  FeelController slow{scene, slow_device};
  slow.start(QStringLiteral("slow"));
  EXPECT_EQ(slow.state(), FeelController::State::kOpening);
  EXPECT_FALSE(slow.isRunning());
  let();
  ASSERT_TRUE(QTest::qWaitFor([&] { return slow.state() == FeelController::State::kRunning; }, kPatience));
  EXPECT_TRUE(slow.isRunning());

  // The call comes back while the device still stops, and what is shown has no force any more.
  lets_go.store(false);
  slow.stop();
  EXPECT_EQ(slow.state(), FeelController::State::kStopping);
  EXPECT_FALSE(slow.isRunning());
  EXPECT_EQ(slow.latest().force_n, 0);
  const QSignalSpy failed(&slow, &FeelController::failed);
  slow.start(QStringLiteral("slow"));
  EXPECT_EQ(slow.state(), FeelController::State::kStopping);
  EXPECT_EQ(failed.count(), 1);
  let();
  EXPECT_TRUE(QTest::qWaitFor([&] { return slow.state() == FeelController::State::kStopped; }, kPatience));
}

TEST_F(FeelDeviceTest, ADeviceThatStillStartsCanBeStopped) {
  std::atomic<bool> lets_go{false};
  DeviceSession slow_device{time.slowSettings(lets_go)};
  FeelController slow{scene, slow_device};
  slow.start(QStringLiteral("slow"));
  slow.stop();
  EXPECT_EQ(slow.state(), FeelController::State::kStopping);
  lets_go.store(true);
  lets_go.notify_all();
  EXPECT_TRUE(QTest::qWaitFor([&] { return slow.state() == FeelController::State::kStopped; }, kPatience));
  EXPECT_FALSE(slow.isRunning());
}

TEST_F(FeelDeviceTest, AGripThatIsChosenWhileADeviceStartsCounts) {
  std::atomic<bool> lets_go{false};
  DeviceSession slow_device{time.slowSettings(lets_go)};
  FeelController slow{scene, slow_device};
  slow.start(QStringLiteral("slow"));
  slow.session().setGrip({true, -20});
  lets_go.store(true);
  lets_go.notify_all();
  ASSERT_TRUE(QTest::qWaitFor([&] { return slow.state() == FeelController::State::kRunning; }, kPatience));
  time.advance(slow, 50);
  slow.session().setHeld(true);
  time.advance(slow, 50);
  slow.session().setHeld(false);
  time.advance(slow, 50);
  // One press took the tube, and nothing has to be held.
  EXPECT_TRUE(slow.latest().enabled);
}

TEST_F(FeelDeviceTest, AProgramThatEndsWaitsForADeviceThatStops) {
  std::atomic<bool> lets_go{true};
  std::thread late;
  {
    DeviceSession slow_device{time.slowSettings(lets_go)};
    FeelController slow{scene, slow_device};
    slow.start(QStringLiteral("slow"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return slow.state() == FeelController::State::kRunning; }, kPatience));
    lets_go.store(false);
    slow.stop();
    late = std::thread([&] {
      lets_go.store(true);
      lets_go.notify_all();
    });
  }
  late.join();
  EXPECT_EQ(time.loops(), 0);
}

TEST_F(FeelDeviceTest, AModelThatIsOpenedWhileADeviceStartsIsTheOneThatIsFelt) {
  std::atomic<bool> lets_go{false};
  DeviceSession slow_device{time.slowSettings(lets_go)};
  FeelController slow{scene, slow_device};
  slow.start(QStringLiteral("slow"));
  ASSERT_TRUE(models.edit(harder()));
  lets_go.store(true);
  lets_go.notify_all();
  ASSERT_TRUE(QTest::qWaitFor([&] { return slow.state() == FeelController::State::kRunning; }, kPatience));
  time.advance(slow, 20);
  slow.session().setHeld(true);
  time.advance(slow, 1200);
  time.moveTo(slow, 5, 5);
  EXPECT_NEAR(slow.latest().model_force_n, kHighN, kFeltRounding);
}

class FeelTripTest : public testing::Test {
 protected:
  static haptics::VirtualDeviceSettings stalling() {
    haptics::VirtualDeviceSettings device;
    device.faults = {{haptics::InjectedFault::kStalled, 0.5, 0.3}};
    return device;
  }

  void SetUp() override {
    models.open(folder.write(tests::twoExperts()));
    feel.start(QStringLiteral("virtual"));
    time.advance(feel, 20);
    feel.session().setHeld(true);
    time.advance(feel, 1100);
  }

  tests::ModelFolder folder;
  ModelController models;
  SceneController scene{models};
  tests::SteppedFeel time{stalling()};
  DeviceSession device_session{time.settings()};
  FeelController feel{scene, device_session};
};

TEST_F(FeelTripTest, IsShownWithCauseValueAndTime) {
  EXPECT_EQ(feel.state(), FeelController::State::kTripped);
  ASSERT_TRUE(feel.session().trip());
  EXPECT_TRUE(feel.session().trip()->at.isValid());
  // A device that stalls takes no force either, which trips first: within a tick or two after 50 ms.
  const std::string sentence = feel.session().trip()->sentence.toStdString();
  EXPECT_TRUE(sentence.starts_with("No force reached the device for too long: 0.05")) << sentence;
  EXPECT_TRUE(sentence.ends_with("s, allowed 0.050 s")) << sentence;
  EXPECT_EQ(feel.latest().force_n, 0);
}

TEST_F(FeelTripTest, ArmsAgainOnceTheHandHasLetGo) {
  feel.session().rearm();
  time.advance(feel, 100);
  EXPECT_EQ(feel.state(), FeelController::State::kRearming);
  feel.session().setHeld(false);
  time.advance(feel, 100);
  EXPECT_EQ(feel.state(), FeelController::State::kRunning);
  EXPECT_FALSE(feel.session().trip());
  feel.session().setHeld(true);
  time.advance(feel, 1200);
  time.moveTo(feel, 5, 5);
  EXPECT_GT(feel.latest().force_n, 0.1);
}

TEST_F(FeelDeviceTest, ALoopThatStopsCallingIsNoticedAndSaidAfterASecond) {
  feel.start(QStringLiteral("virtual"));
  push();
  const QSignalSpy failures(&feel, &FeelController::failed);
  time.stall(feel, 990);
  EXPECT_TRUE(feel.isRunning());
  time.stall(feel, 40);
  EXPECT_EQ(feel.state(), FeelController::State::kStopped);
  ASSERT_EQ(failures.count(), 1);
  const QString sentence = failures.front().front().toString();
  EXPECT_TRUE(sentence.startsWith(
      QStringLiteral("The loop of the device's driver has ended: the servo missed ticks for too long: 1.0")))
      << sentence.toStdString();
  EXPECT_EQ(feel.latest().force_n, 0);
}

TEST_F(FeelDeviceTest, AStallThatTheDeviceDoesNotBridgeBeginsANewFadeIn) {
  haptics::VirtualDeviceSettings device;
  device.quiet_after_s = 0.05;
  tests::SteppedFeel stalling(device);
  DeviceSession felt_device{stalling.settings()};
  FeelController felt{scene, felt_device};
  felt.start(QStringLiteral("virtual"));
  stalling.advance(felt, 20);
  felt.session().setHeld(true);
  stalling.advance(felt, 1200);
  stalling.moveTo(felt, 5, 5);
  const double before_n = felt.latest().force_n;
  ASSERT_GT(before_n, 0.1);
  stalling.stall(felt, 70);
  stalling.advance(felt, 2);
  EXPECT_EQ(felt.state(), FeelController::State::kRunning);
  EXPECT_LT(felt.latest().force_n, 0.01 * before_n);
  EXPECT_TRUE(felt.latest().limited & haptics::kLimitedByGap);
  EXPECT_EQ(felt.session().statistics().restarts, 1u);
}

TEST_F(FeelDeviceTest, TheMotorsAreAsWarmAfterStopAndStartAsBefore) {
  haptics::VirtualDeviceSettings device;
  device.continuous_force_n = 0.05;
  tests::SteppedFeel warm(device);
  DeviceSession felt_device{warm.settings()};
  FeelController felt{scene, felt_device};
  const auto hold = [&] {
    felt.start(QStringLiteral("virtual"));
    warm.advance(felt, 20);
    felt.session().setHeld(true);
    warm.advance(felt, 1200);
    warm.moveTo(felt, 10, 20);
  };
  hold();
  const double fresh_n = felt.latest().force_n;
  warm.advance(felt, 20'000);
  const double tired_n = felt.latest().force_n;
  ASSERT_TRUE(felt.latest().limited & haptics::kLimitedByThermal);
  ASSERT_LT(tired_n, 0.5 * fresh_n);
  felt.stop();
  hold();
  EXPECT_TRUE(felt.latest().limited & haptics::kLimitedByThermal);
  EXPECT_LT(felt.latest().force_n, 0.5 * fresh_n);
  felt.stop();
  warm.pass(65'000);
  hold();
  EXPECT_NEAR(felt.latest().force_n, fresh_n, 1e-6) << "the time in between was rest";
}

}  // namespace
}  // namespace tactus::workbench
