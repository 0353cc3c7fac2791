// The budget of the motors continues where the previous servo left it.
#include <cmath>
#include <gtest/gtest.h>
#include <optional>
#include <vector>

#include "core/haptics/safety/thermal_budget.h"
#include "core/haptics/servo/servo.h"

#include "tests/core/haptics/loop_numbers.h"
#include "tests/core/haptics/safety/thermal_rating.h"
#include "tests/core/haptics/scripted_device.h"

namespace tactus::haptics {
namespace {

constexpr int kWindowTicks = 60'000;

/// A person who presses Start, feels 2 N for a while, and presses Stop; again and again.
class StartAndStop {
 public:
  explicit StartAndStop(ThermalLedger* ledger) : ledger_(ledger) {}

  void feel(int ticks) {
    ScriptedDevice device;
    Servo servo(device, ledger_);
    ServoOrders orders;
    orders.source = ForceSource::kStimulus;
    orders.armed = true;
    orders.stimulus = {1, 2, 0, {}, {}};
    orders.limits.fade_in_s = 0;
    orders.limits.stimulus_hold_s = 1e6;
    servo.post(orders);
    for (int i = 0; i < ticks; ++i) {
      device.pressed = i > 3;
      servo.tick(now_ns_ += kTickNs);
      force_n.push_back(device.z_n);
    }
  }
  void rest(int ticks) {
    now_ns_ += ticks * kTickNs;
    force_n.insert(force_n.end(), static_cast<std::size_t>(ticks), 0);
  }

  /// The largest rms of any 60 s, N.
  double largestRmsN() const {
    double sum = 0;
    double most = 0;
    for (std::size_t i = 0; i < force_n.size(); ++i) {
      sum += force_n[i] * force_n[i];
      if (i >= kWindowTicks) sum -= force_n[i - kWindowTicks] * force_n[i - kWindowTicks];
      most = std::max(most, sum);
    }
    return std::sqrt(most / kWindowTicks);
  }

  std::vector<double> force_n;  ///< in each millisecond

 private:
  ThermalLedger* ledger_;
  std::int64_t now_ns_ = 0;
};

TEST(ThermalLedger, StopAndStartDoNotCoolTheMotors) {
  ThermalLedger ledger;
  StartAndStop with(&ledger);
  StartAndStop without(nullptr);
  for (int i = 0; i < 12; ++i) {
    for (StartAndStop* run : {&with, &without}) {
      run->feel(10'000);
      run->rest(2'000);
    }
  }
  EXPECT_LE(with.largestRmsN(), kRatingN);
  EXPECT_GT(with.largestRmsN(), 0.8) << "and it is used";
  EXPECT_GT(without.largestRmsN(), 1.7) << "what the ledger is for: 2 N for 10 of 12 s";
}

TEST(ThermalLedger, TheTimeBetweenCountsAsRest) {
  ThermalLedger ledger;
  StartAndStop run(&ledger);
  run.feel(15'000);
  EXPECT_LT(run.force_n.back(), 1.9);
  run.rest(61'000);
  run.feel(5'000);
  EXPECT_EQ(run.force_n.back(), 2);
}

TEST(ThermalLedger, EachDeviceHasABudgetOfItsOwn) {
  ThermalLedger ledger;
  ThermalBudget warm;
  warm.advance(0, 0, 1, 60);
  warm.advance(1'000'000'000, 3, 1, 60);
  ledger.keep("hid:1", warm);
  EXPECT_EQ(ledger.of("hid:1").share(), warm.share());
  EXPECT_GT(ledger.of("hid:1").share(), 0.1);
  EXPECT_EQ(ledger.of("hid:2").share(), 0);
}

}  // namespace
}  // namespace tactus::haptics
