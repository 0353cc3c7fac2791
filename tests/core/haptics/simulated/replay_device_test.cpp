#include "core/haptics/simulated/replay_device.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <memory>
#include <string>

#include "core/haptics/device/device.h"

#include "tests/core/haptics/simulated/axis_mm.h"
#include "tests/core/haptics/simulated/virtual_clock.h"
#include "tests/support/real_time_trap.h"

namespace tactus::haptics {
namespace {

study::Recording wave(double rate_hz, int count) {
  study::Recording recording;
  recording.sample_rate_hz = rate_hz;
  study::Channel position{"position", "mm", {}};
  for (int i = 0; i < count; ++i) position.values.push_back(5 + 20 * std::sin(0.05 * i) + 1.0 / 3);
  recording.channels = {std::move(position)};
  return recording;
}

std::unique_ptr<ReplayDevice> replaying(const study::Recording& recording, const ReplaySettings& settings = {}) {
  auto device = ReplayDevice::make(recording, settings);
  EXPECT_TRUE(device) << device.error().message();
  EXPECT_TRUE((*device)->start());
  return std::move(*device);
}

TEST(ReplayDevice, SaysThatItIsSimulated) {
  const auto device = replaying(wave(1000, 10));
  EXPECT_TRUE(device->info().simulated);
  EXPECT_EQ(device->info().backend, "replay");
}

TEST(ReplayDevice, GivesTheRecordedPositionsToTheBit) {
  const auto recording = wave(1000, 500);
  const auto device = replaying(recording);
  for (int i = 0; i < 100; ++i) {
    const DeviceState state = device->read(tickNs(i));
    ASSERT_EQ(axisMm(state), recording.channels[0].values[0]) << "lead";
    ASSERT_EQ(state.buttons, 0U);
  }
  for (int i = 0; i < 500; ++i) {
    const DeviceState state = device->read(tickNs(100 + i));
    ASSERT_EQ(axisMm(state), recording.channels[0].values[static_cast<std::size_t>(i)]) << i;
    ASSERT_EQ(state.number, 101U + static_cast<unsigned>(i));
    ASSERT_EQ(state.time_ns, tickNs(100 + i));
    ASSERT_EQ(state.buttons, 1U);
  }
  for (int i = 600; i < 700; ++i) {
    const DeviceState state = device->read(tickNs(i));
    ASSERT_EQ(axisMm(state), recording.channels[0].values.back());
    ASSERT_EQ(state.buttons, 0U);
  }
  EXPECT_EQ(device->lengthNs(), 599 * kTickNs);
}

TEST(ReplayDevice, InterpolatesOtherRatesOnStraightLines) {
  const auto recording = wave(250, 50);
  const auto& values = recording.channels[0].values;
  const auto device = replaying(recording, {.lead_s = 0});
  for (int i = 0; i < 4 * 49; ++i) {
    const auto k = static_cast<std::size_t>(i / 4);
    const double expected_mm = values[k] + (values[k + 1] - values[k]) * (i % 4) / 4;
    ASSERT_NEAR(axisMm(device->read(tickNs(i))), expected_mm, 1e-13) << i;
  }
}

TEST(ReplayDevice, TimesOfTheRecordingCountBeforeItsRate) {
  study::Recording recording;
  recording.sample_rate_hz = 1000;
  recording.channels = {{"time", "s", {10, 10.002, 10.01}}, {"depth", "mm", {0, 4, 20}}, {"force", "N", {0, 0, 0}}};
  const auto device = replaying(recording, {.lead_s = 0});
  const double expected_mm[] = {0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 20};
  for (int i = 0; i < 12; ++i) EXPECT_NEAR(axisMm(device->read(tickNs(i))), expected_mm[i], 1e-12) << i;
}

TEST(ReplayDevice, ALoopComesBackWithoutAJump) {
  const auto recording = wave(1000, 40);
  const auto device = replaying(recording, {.lead_s = 0.01, .loop = true, .return_s = 0.1});
  const int period = 10 + 39 + 100;
  double before_mm = recording.channels[0].values[0];
  for (int i = 0; i < 3 * period; ++i) {
    const DeviceState state = device->read(tickNs(i));
    // The wave moves at most 1 mm a tick; the way back is 1.875 times its mean of 0.2 mm.
    ASSERT_LE(std::abs(axisMm(state) - before_mm), 1 + 1e-12) << i;
    before_mm = axisMm(state);
    const int at = i % period;
    ASSERT_EQ(state.buttons, at >= 10 && at <= 49 ? 1U : 0U) << i;
    if (at >= 10 && at <= 49) {
      ASSERT_EQ(axisMm(state), recording.channels[0].values[static_cast<std::size_t>(at) - 10]);
    }
  }
}

TEST(ReplayDevice, KeepsTheForcesItIsTold) {
  const auto device = replaying(wave(1000, 10), {.lead_s = 0, .room_for_forces = 5});
  for (int i = 0; i < 7; ++i) {
    const DeviceState state = device->read(tickNs(i));
    ASSERT_EQ(state.written_ns, i == 0 ? 0 : tickNs(i - 1));
    device->write({0, 0, 0.1 * i}, tickNs(i));
  }
  ASSERT_EQ(device->forces().size(), 5U);
  EXPECT_EQ(device->forcesLost(), 2U);
  const auto values = wave(1000, 10).channels[0].values;
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_EQ(device->forces()[i], (CommandedForce{tickNs(static_cast<int>(i)), values[i], {0, 0, 0.1 * double(i)}}));
  ASSERT_TRUE(device->start());
  EXPECT_TRUE(device->forces().empty());
  EXPECT_EQ(axisMm(device->read(tickNs(1000))), values[0]);
}

TEST(ReplayDevice, StoppedItStays) {
  const auto device = replaying(wave(1000, 100), {.lead_s = 0});
  device->read(tickNs(0));
  const DeviceState state = device->read(tickNs(50));
  device->stop();
  device->write({0, 0, 1}, tickNs(51));
  EXPECT_EQ(device->read(tickNs(51)).position_mm, state.position_mm);
  EXPECT_TRUE(device->forces().empty());
}

TEST(ReplayDevice, ReadAndWriteAreRealTimeSafe) {
  const auto device = replaying(wave(700, 500), {.loop = true, .room_for_forces = 100});
  support::RealTimeTrap trap;
  for (int i = 0; i < 3000; ++i) {
    device->read(tickNs(i));
    device->write({0, 0, 0.2}, tickNs(i));
  }
  trap.disarm();
  EXPECT_EQ(trap.hits(), 0) << trap.first();
}

TEST(ReplayDevice, RecordingsThatCannotBePlayedAreRefusedInOneSentence) {
  const auto message = [](auto change, ReplaySettings settings = {}) {
    study::Recording recording;
    recording.channels = {{"time", "s", {0, 1, 2}}, {"depth", "mm", {0, 4, 20}}};
    change(recording);
    const auto made = ReplayDevice::make(recording, settings);
    return made ? std::string("accepted") : made.error().message();
  };
  using R = study::Recording;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message([](R&) {}), "accepted");
  EXPECT_EQ(message([](R& r) { r.channels.clear(); }),
            "recording: found no channel of positions, wanted a channel 'position' or 'depth'");
  EXPECT_EQ(message([](R& r) {
              r.channels = {{"depth", "mm", {1}}};
            }),
            "recording: found 1 samples, wanted at least 2");
  EXPECT_EQ(message([](R& r) { r.channels[1].unit = "cm"; }),
            "recording: channel 'depth': found unit 'cm', wanted unit 'mm'");
  EXPECT_EQ(message([](R& r) { r.channels[1].values.pop_back(); }),
            "recording: channel 'depth': found 2 samples, wanted 3, as in the first channel");
  EXPECT_EQ(message([=](R& r) { r.channels[1].values[1] = nan; }),
            "recording: channel 'depth', sample 2: found nan, wanted a finite number");
  EXPECT_EQ(message([](R& r) { r.channels[0].values[2] = 1; }),
            "recording: channel 'time', sample 3: found 1 s after 1 s, wanted times that rise, within 1e6 s");
  EXPECT_EQ(message([](R& r) { r.channels[0].values[2] = 2e6; }),
            "recording: channel 'time', sample 3: found 2e+06 s after 1 s, wanted times that rise, within 1e6 s");
  for (const double rate_hz : {0.0, -1.0, nan, 1e-7, 1e10})
    EXPECT_NE(message([&](R& r) {
                r.channels.erase(r.channels.begin());
                r.sample_rate_hz = rate_hz;
              }).find("recording: sample rate: found "),
              std::string::npos)
        << rate_hz;
  EXPECT_EQ(message([](R&) {}, {.lead_s = -1}), "replay: lead_s: found -1, wanted a number in [0, 100]");
  EXPECT_EQ(message([](R&) {}, {.return_s = 0}), "replay: return_s: found 0, wanted a number in [0.01, 100]");
}

}  // namespace
}  // namespace tactus::haptics
