#include "core/haptics/hid/pid_session.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "core/haptics/hid/hid_pid_device.h"

#include "tests/core/haptics/hid/pid_run.h"
#include "tests/core/haptics/loop_numbers.h"

namespace tactus::haptics {
namespace {

using support::PidModel;

TEST(PidSession, BeginsOnTheBoardWithTheseBytes) {
  PidRun run(PidModel::kBoard);
  ASSERT_TRUE(run.session.begin(run.now()));
  const Bytes set_x = {0x01, 1, 1, 90, 0, 0, 0, 0, 0, 0, 0, 255, 255, 4, 0x28, 0x23, 0, 0, 0, 0, 0, 0};
  const Bytes set_y = {0x01, 2, 1, 90, 0, 0, 0, 0, 0, 0, 0, 255, 255, 4, 0, 0, 0, 0, 0, 0, 0, 0};
  const std::vector<Bytes> expected = {{0x0C, 8}, {0x0C, 1},       {0x0D, 255},     {0x11, 1, 0, 0},
                                       set_x,     {0x05, 1, 0, 0}, {0x0A, 1, 1, 1}, {0x11, 1, 0, 0},
                                       set_y,     {0x05, 2, 0, 0}, {0x0A, 2, 1, 1}};
  EXPECT_EQ(run.reports(), expected);
  EXPECT_TRUE(run.line->device().complaints().empty());
  EXPECT_EQ(run.pauses, 0);
}

TEST(PidSession, BeginsOnTheSketchWithTheseBytes) {
  PidRun run(PidModel::kSketch);
  ASSERT_TRUE(run.session.begin(run.now()));
  const auto reports = run.reports();
  ASSERT_EQ(reports.size(), 11U);
  EXPECT_EQ(reports[0], (Bytes{12, 4}));
  EXPECT_EQ(reports[1], (Bytes{12, 1}));
  EXPECT_EQ(reports[4], (Bytes{1, 1, 1, 90, 0, 0, 0, 0, 0, 255, 255, 4, 64, 0, 0, 0, 0, 0}));
}

TEST(PidSession, BeginsOnTheWheelAndWaitsForItsMemory) {
  PidRun run(PidModel::kWheel);
  ASSERT_TRUE(run.session.begin(run.now()));
  const std::vector<Bytes> expected = {
      {0x4C, 4},       {0x4C, 2},      {0x4D, 255}, {0x51, 3}, {0x41, 1, 3, 90, 0, 0x10, 0x27, 255, 2, 0x28, 0x23},
      {0x45, 1, 0, 0}, {0x4A, 1, 1, 1}};
  EXPECT_EQ(run.reports(), expected);
  EXPECT_EQ(run.pauses, 3) << "the model answers the fourth question";
}

TEST(PidSession, TheForceArrivesOnEveryModel) {
  for (const PidModel model : support::kPidModels) {
    PidRun run(model);
    ASSERT_TRUE(run.session.begin(run.now()));
    // The signs of the models' firmware differ, which is what a calibration finds out.
    const double sign_x = model == PidModel::kBoard ? -1 : 1;
    const double sign_y = model == PidModel::kBoard ? 1 : -1;
    // 8-bit directions are 0.35 degrees off, so one axis gives 0.6 % to the other; else the step of the magnitude.
    const double tolerance = model == PidModel::kSketch ? 7e-3 : 1e-4;
    for (const double share : {0.25, -0.25, 1.0, -1.0, 0.0}) {
      run.line->now_ns += kMs;
      run.send(share, -0.5 * share);
      EXPECT_NEAR(run.force()[0], sign_x * share, tolerance) << name(model) << " " << share;
      if (run.line->device().forceAxes() == 2) {
        EXPECT_NEAR(run.force()[1], -sign_y * 0.5 * share, tolerance) << name(model) << " " << share;
      }
    }
    EXPECT_EQ(run.line->device().complaints(), std::vector<std::string>()) << name(model);
  }
}

TEST(PidSession, OnlyWhatChangedOrIsOldIsSent) {
  PidRun run(PidModel::kBoard);
  ASSERT_TRUE(run.session.begin(run.now()));
  run.line->forget();
  run.line->now_ns += kMs;
  run.send(0.5, 0);
  EXPECT_EQ(run.reports(), (std::vector<Bytes>{{0x05, 1, 0x00, 0x40}})) << "round(0.5 * 32767) = 16384";
  run.line->now_ns += kMs;
  run.send(0.5, 0);
  EXPECT_EQ(run.reports().size(), 1U);
  run.line->now_ns += 9 * kMs;
  run.send(0.5, 0);
  EXPECT_EQ(run.reports().size(), 3U) << "both values are 10 ms old or more";
}

TEST(PidSession, ClampsAndKnowsNoForceThatIsNoNumber) {
  PidRun run(PidModel::kSketch);
  ASSERT_TRUE(run.session.begin(run.now()));
  run.line->forget();
  run.line->now_ns += kMs;
  run.send(1.2345, -7);
  run.line->now_ns += kMs;
  run.send(std::nan(""), -7);
  EXPECT_EQ(run.reports(), (std::vector<Bytes>{{5, 1, 0x10, 0x27}, {5, 2, 0xF0, 0xD8}, {5, 1, 0, 0}}));
}

TEST(PidSession, AMagnitudeWithoutASignTurnsOnlyWhileItIsZero) {
  PidRun run(PidModel::kWheel);
  ASSERT_TRUE(run.session.begin(run.now()));
  run.line->forget();
  run.line->now_ns += kMs;
  run.send(0.3, 0);
  run.line->now_ns += kMs;
  run.send(-0.3, 0);
  const std::vector<Bytes> expected = {{0x45, 1, 0xB8, 0x0B},
                                       {0x45, 1, 0, 0},
                                       {0x41, 1, 3, 90, 0, 0x10, 0x27, 255, 2, 0x78, 0x69},
                                       {0x45, 1, 0xB8, 0x0B}};
  EXPECT_EQ(run.reports(), expected) << "3000, 0, 270 degrees, 3000";
  const auto device = run.line->device();
  for (const auto& change : device.forces())
    EXPECT_TRUE(change.share[0] == 0 || std::abs(std::abs(change.share[0]) - 0.3) < 1e-9);
}

TEST(PidSession, EffectsAreRestartedEvery40MsSoThatTheForceHasNoGap) {
  for (const PidModel model : support::kPidModels) {
    PidRun run(model);
    ASSERT_TRUE(run.session.begin(run.now()));
    const std::uint8_t operation = model == PidModel::kBoard ? 0x0A : model == PidModel::kSketch ? 10 : 0x4A;
    run.send(0.2, 0.2);
    run.line->forget();
    const std::int64_t begin = run.now();
    for (int tick = 1; tick <= 2000; ++tick) {
      run.line->now_ns = begin + tick * kMs;
      run.send(0.2, 0.2);
      ASSERT_GT(std::abs(run.force()[0]), 0.19) << name(model) << " tick " << tick;
    }
    int starts = 0;
    for (const Bytes& report : run.reports()) starts += report[0] == operation ? 1 : 0;
    EXPECT_EQ(starts, 50 * run.line->device().forceAxes()) << name(model) << ": 2 s / 40 ms";
  }
}

TEST(PidSession, WhenTheHostDiesTheForceEndsWithin100Ms) {
  for (const PidModel model : support::kPidModels) {
    for (int alive_ms = 1; alive_ms <= 120; alive_ms += 7) {
      PidRun run(model);
      ASSERT_TRUE(run.session.begin(run.now()));
      for (int tick = 0; tick < alive_ms; ++tick) {
        run.line->now_ns += kMs;
        run.send(0.4, -0.4);
      }
      const std::int64_t death = run.now();
      auto device = run.line->device();
      device.advance(death + 10'000 * kMs);
      ASSERT_FALSE(device.forces().empty());
      EXPECT_EQ(device.forces().back().share, (std::array<double, 2>{})) << name(model);
      EXPECT_LE(device.forces().back().time_ns - death, 100 * kMs) << name(model);
      EXPECT_GE(device.forces().back().time_ns - death, 50 * kMs) << "a host that stumbles keeps its force";
    }
  }
}

TEST(PidSession, LeavingEndsEverythingInThisOrder) {
  PidRun run(PidModel::kBoard);
  ASSERT_TRUE(run.session.begin(run.now()));
  run.send(0.5, 0.5);
  run.line->forget();
  EXPECT_TRUE(run.session.leave());
  const std::vector<Bytes> expected = {{0x05, 1, 0, 0}, {0x05, 2, 0, 0}, {0x0A, 1, 3, 1}, {0x0A, 2, 3, 1},
                                       {0x0B, 1},       {0x0B, 2},       {0x0C, 4},       {0x0C, 2}};
  EXPECT_EQ(run.reports(), expected);
  for (const PidModel model : support::kPidModels) {
    PidRun other(model);
    ASSERT_TRUE(other.session.begin(other.now()));
    other.send(0.5, 0.5);
    EXPECT_TRUE(other.session.leave());
    const auto device = other.line->device();
    EXPECT_EQ(device.force(other.now()), (std::array<double, 2>{})) << name(model);
    EXPECT_EQ(device.effectsInUse(), 0) << name(model);
    EXPECT_FALSE(device.actuatorsOn()) << name(model);
    EXPECT_EQ(device.complaints(), std::vector<std::string>()) << name(model);
  }
}

TEST(PidSession, AFailedWriteIsSentAgain) {
  PidRun run(PidModel::kBoard);
  ASSERT_TRUE(run.session.begin(run.now()));
  run.line->writes_fail = true;
  EXPECT_FALSE(run.session.send({0.5, 0}, run.now()));
  EXPECT_FALSE(run.session.leave()) << "nothing got through";
  PidRun again(PidModel::kBoard);
  ASSERT_TRUE(again.session.begin(again.now()));
  again.line->writes_fail = true;
  EXPECT_FALSE(again.session.send({0.5, 0}, again.now()));
  again.line->writes_fail = false;
  again.send(0.5, 0);
  EXPECT_NEAR(again.force()[0], -0.5, 1e-4);
}

TEST(PidSession, ADeviceWithoutRoomIsRefusedAndLeftQuiet) {
  PidRun run(PidModel::kSketch);
  run.line->with([](support::FakePidDevice& device) {
    // Another program holds all 14 blocks, and the reset does not free them.
    for (int i = 0; i < 14; ++i) device.setFeature(Bytes{5, 1, 0, 0}, 0);
  });
  PidLayout layout = run.session.layout();
  layout.control->reset.reset();
  PidSession session(
      run.transport, layout, [](int) {}, [&] { return run.now(); });
  const auto begun = session.begin(run.now());
  ASSERT_FALSE(begun);
  EXPECT_EQ(begun.error().message(),
            "force effect: found no room for it in the device, wanted a free effect (close other programs that use the "
            "device)");
  EXPECT_FALSE(run.line->device().actuatorsOn());
}

TEST(PidSession, ADeviceThatNeverAnswersIsGivenUpAfter60Questions) {
  PidRun run(PidModel::kSketch);
  PidLayout layout = run.session.layout();
  layout.block_load.success->value = 9;
  int pauses = 0;
  PidSession session(
      run.transport, layout, [&](int ms) { pauses += ms; }, [&] { return run.now(); });
  const auto begun = session.begin(run.now());
  ASSERT_FALSE(begun);
  EXPECT_EQ(begun.error().message(),
            "force effect: found no answer of the device after 60 questions, wanted a loaded effect");
  EXPECT_EQ(pauses, 59);
}

TEST(PidSession, ADeviceThatLeavesTheFirstQuestionUnansweredIsGivenUpAtOnce) {
  PidRun run(PidModel::kBoard);
  ASSERT_TRUE(run.session.layout().pool) << "what is asked first";
  const std::int64_t begin_ns = run.now();
  run.line->unanswered_takes_ns = 5000 * kMs;  // as the kernel waits
  const auto begun = run.session.begin(run.now());
  ASSERT_FALSE(begun);
  EXPECT_EQ(begun.error().message(),
            "device: found no answer to the first question, wanted a device that answers (unplug it, then plug it in "
            "again)");
  EXPECT_EQ(run.line->questions, 1);
  EXPECT_TRUE(run.reports().empty());
  EXPECT_EQ(run.now() - begin_ns, 5000 * kMs);
}

TEST(PidSession, ADeviceThatRefusesThePoolReportIsUsed) {
  PidRun run(PidModel::kBoard);
  PidLayout layout = run.session.layout();
  layout.pool->id = 0x7F;  // the model knows none
  PidSession session(
      run.transport, layout, [](int) {}, [&] { return run.now(); });
  const auto begun = session.begin(run.now());
  EXPECT_TRUE(begun) << begun.error().message();
}

/// Ten newtons at full scale, y turned round.
DeviceCalibration tenNewtons() {
  DeviceCalibration calibration;
  calibration.full_scale_n = 10;
  calibration.force_sign = {1, 1, -1};
  return calibration;
}

TEST(PidWriter, NewtonsBecomeSharesOfFullScaleWithTheSignOfTheDevice) {
  PidRun run(PidModel::kBoard);
  const PidWriter writer(run.session, tenNewtons());
  // Toward the person is z of the device's frame and Y of HID.
  EXPECT_EQ(writer.sharesOf({2, 5, 3}), (std::array<double, 2>{0.2, -0.3}));
  EXPECT_EQ(writer.sharesOf({-200, 0, -200}), (std::array<double, 2>{-1, 1}));
  EXPECT_EQ(writer.sharesOf({std::numeric_limits<double>::infinity(), 0, 1}), (std::array<double, 2>{}));
  EXPECT_EQ(writer.sharesOf({0, std::nan(""), 1}), (std::array<double, 2>{}));
  EXPECT_EQ(fromHidAxes(hidAxesOf({1, 2, 3})), (Vector3{1, 2, 3}));
}

TEST(PidWriter, OnlyTheNewestCommandIsSent) {
  PidRun run(PidModel::kSketch);
  ASSERT_TRUE(run.session.begin(run.now()));
  PidWriter writer(run.session, tenNewtons());
  run.line->forget();
  for (int i = 1; i <= 9; ++i) writer.commands().put({{static_cast<double>(i), 0, 0}, run.now(), true});
  ASSERT_TRUE(writer.step(run.now()));
  EXPECT_EQ(run.reports(), (std::vector<Bytes>{{5, 1, 0x28, 0x23}})) << "9000 of 10000";
}

TEST(PidWriter, OnASlowLineOldCommandsAreLeftOutAndNoneWaits) {
  PidRun run(PidModel::kSketch);
  ASSERT_TRUE(run.session.begin(run.now()));
  PidWriter writer(run.session, tenNewtons());
  run.line->forget();
  run.line->write_takes_ns = 5 * kMs;
  std::int64_t servo_ns = run.now();
  int rounds = 0;
  for (int tick = 1; tick <= 300; ++tick) {
    servo_ns += kMs;
    writer.commands().put({{0.01 * tick, 0, 0}, servo_ns, true});
    if (run.now() > servo_ns) continue;  // the last round is not over
    run.line->now_ns = servo_ns;
    ASSERT_TRUE(writer.step(servo_ns));
    ++rounds;
    EXPECT_NEAR(run.force()[0], 0.001 * tick, 1e-4) << "the newest one";
  }
  EXPECT_LE(rounds, 60) << "300 ms, at least 5 ms each";
  EXPECT_GE(rounds, 20) << "at most 15 ms each: both axes and a restart";
}

TEST(PidWriter, WithoutAServoThereIsNoForce) {
  PidRun run(PidModel::kSketch);
  ASSERT_TRUE(run.session.begin(run.now()));
  PidWriter writer(run.session, tenNewtons());
  ASSERT_TRUE(writer.step(run.now()));
  EXPECT_EQ(run.force()[0], 0) << "no command yet";
  writer.commands().put({{4, 0, 0}, run.now(), true});
  for (int tick = 0; tick <= 40; ++tick, run.line->now_ns += kMs) {
    ASSERT_TRUE(writer.step(run.now()));
    EXPECT_NEAR(run.force()[0], 0.4, 1e-4) << tick;
    EXPECT_FALSE(writer.letsGo(run.now()));
  }
  // Then it lets go within 5 ms, evenly, in rounds without a request.
  for (int tick = 41; tick < 45; ++tick, run.line->now_ns += kMs) {
    EXPECT_TRUE(writer.letsGo(run.now()));
    ASSERT_TRUE(writer.step(run.now()));
    EXPECT_NEAR(run.force()[0], 0.4 * (45 - tick) / 5, 1e-4) << tick;
  }
  ASSERT_TRUE(writer.step(run.now()));
  EXPECT_EQ(run.force()[0], 0) << "the command is 45 ms old";
  EXPECT_FALSE(writer.letsGo(run.now()));
}

}  // namespace
}  // namespace tactus::haptics
