#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <vector>

#include "app/devices/guided_runs.h"

namespace tactus::devices {
namespace {

std::int64_t g_now_ns = 0;
CalibrationClock virtualClock() noexcept {
  return {[]() noexcept { return g_now_ns; },
          [](std::int64_t time_ns) noexcept { g_now_ns = std::max(g_now_ns, time_ns); }};
}

/// A handle on one axis that reports counts and moves by 500 counts/s once it is pushed by more than 3 % of full scale.
class RawHandle final : public haptics::HapticDevice {
 public:
  RawHandle() {
    info_.id = "hid:1209:ffb0";
    info_.serial = "A1";
    info_.force_axes = 1;
  }
  const haptics::DeviceInfo& info() const noexcept override { return info_; }
  base::Result<void> start() override {
    running = true;
    return {};
  }
  void stop() noexcept override { running = false; }
  haptics::DeviceState read(std::int64_t now_ns) noexcept override {
    if (!held && std::abs(force) > 0.03) counts += std::copysign(0.5, force);
    haptics::DeviceState state;
    state.number = ++number_;
    state.time_ns = now_ns;
    state.position_mm.x = std::round(counts);
    state.fault = g_now_ns >= lost_at_ns ? haptics::DeviceFault::kLost : haptics::DeviceFault::kNotCalibrated;
    return state;
  }
  void write(const haptics::Vector3& force_n, std::int64_t) noexcept override {
    before = force;
    force = force_n.x;
  }

  double counts = 0;
  double force = 0;
  double before = 0;  ///< the force before this one
  bool held = false;
  bool running = false;
  std::int64_t lost_at_ns = INT64_MAX;

 private:
  haptics::DeviceInfo info_;
  std::uint64_t number_ = 0;
};

/// Answers 0.7 s after each instruction, and moves the handle where it is told to.
class Person final : public CalibrationGuide {
 public:
  explicit Person(RawHandle& handle) : handle_(handle) {}

  void instruct(const std::string& sentence) override {
    instructions.push_back(sentence);
    told_ns_ = g_now_ns;
    outer_ = handle_.counts;
    answered_ = 0;
  }
  void refuse(const std::string& sentence) override { refusals.push_back(sentence); }
  std::optional<std::string> answer() override {
    if (g_now_ns - told_ns_ < 700'000'000) return std::nullopt;
    const std::string& now = instructions.back();
    for (const auto& [part, answers] : answers_) {
      if (now.find(part) == std::string::npos) continue;
      if (part == "Move the handle along") handle_.counts = outer_ + 1000;
      if (part == "a spring scale that pulls") handle_.held = true;
      if (answered_ < answers.size()) return answers[answered_++];
    }
    return "";
  }

  /// In the middle of a push.
  bool interrupted() const noexcept override {
    return !interrupts_at.empty() && !instructions.empty() && g_now_ns - told_ns_ > 300'000'000 &&
           instructions.back().find(interrupts_at) != std::string::npos;
  }

  std::string interrupts_at;
  void says(const std::string& part, std::vector<std::string> answers) { answers_[part] = std::move(answers); }
  std::vector<std::string> instructions;
  std::vector<std::string> refusals;

 private:
  RawHandle& handle_;
  std::int64_t told_ns_ = 0;
  double outer_ = 0;
  std::size_t answered_ = 0;
  std::map<std::string, std::vector<std::string>> answers_{{"Move the handle along", {""}},
                                                           {"a spring scale that pulls", {""}},
                                                           {"Type how far the handle moved", {"far", "2000", " 100 "}},
                                                           {"Type what the spring scale reads", {"0.5"}},
                                                           {"The push is stronger now", {"1"}}};
};

class CalibrationRun : public testing::Test {
 protected:
  void SetUp() override { g_now_ns = 1; }
  base::Result<haptics::DeviceCalibration> run() {
    return runCalibration(handle_, haptics::planFor(handle_.info()), "2026-11-21T08:00:00Z", person_, virtualClock());
  }
  RawHandle handle_;
  Person person_{handle_};
};

TEST_F(CalibrationRun, LeadsToTheNumbersOfTheDevice) {
  const auto calibration = run();
  ASSERT_TRUE(calibration) << calibration.error().message();
  EXPECT_EQ(calibration->device, "hid:1209:ffb0");
  EXPECT_EQ(calibration->serial, "A1");
  EXPECT_NEAR(calibration->full_scale_n, 5, 1e-12);    // (1 N - 0.5 N) / (20 % - 10 %)
  EXPECT_NEAR(calibration->mm_per_count, 0.1, 1e-12);  // 100 mm on 1000 counts
  EXPECT_EQ(calibration->force_sign.x, 1);
  EXPECT_EQ(calibration->measured_at, "2026-11-21T08:00:00Z");
  EXPECT_FALSE(handle_.running);
  EXPECT_EQ(handle_.force, 0);
  ASSERT_EQ(person_.refusals.size(), 2u);
  EXPECT_EQ(person_.refusals[0], "found 'far', wanted a number such as 1.5, or stop");
  EXPECT_EQ(person_.refusals[1], "measurement: found 2000, wanted a number from 5 to 1000");
}

TEST_F(CalibrationRun, StopEndsItAndLeavesNoForce) {
  person_.says("Type what the spring scale reads", {"stop"});
  const auto calibration = run();
  ASSERT_FALSE(calibration);
  EXPECT_NE(calibration.error().message().find("canceled"), std::string::npos) << calibration.error().message();
  EXPECT_FALSE(handle_.running);
  EXPECT_EQ(handle_.force, 0);
}

TEST_F(CalibrationRun, ADeviceThatIsLostEndsIt) {
  handle_.lost_at_ns = 2'000'000'000;
  const auto calibration = run();
  ASSERT_FALSE(calibration);
  EXPECT_EQ(calibration.error().message(),
            "hid:1209:ffb0: found the device is gone, wanted a device that stays plugged in");
  EXPECT_FALSE(handle_.running);
}

TEST_F(CalibrationRun, AnInterruptionEndsItAndLeavesNoForce) {
  person_.interrupts_at = "Type what the spring scale reads";
  const auto calibration = run();
  ASSERT_FALSE(calibration);
  EXPECT_EQ(calibration.error().message(),
            "hid:1209:ffb0: found an interruption, and the device was stopped, wanted a complete calibration");
  EXPECT_NE(handle_.before, 0) << "it pushed";
  EXPECT_FALSE(handle_.running);
  EXPECT_EQ(handle_.force, 0);
}

}  // namespace
}  // namespace tactus::devices
