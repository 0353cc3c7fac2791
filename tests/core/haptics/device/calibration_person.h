// A device whose numbers are known, and a person who follows the calibration procedure on it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <utility>

#include "core/haptics/device/calibration_procedure.h"

namespace tactus::haptics {

inline constexpr double kCalibrationTickS = 0.001;

/// A handle of 0.15 kg on a device whose numbers the procedure has to find.
struct UncalibratedDevice {
  double full_scale_n = 8;
  double mm_per_count = 0.02;
  Vector3 sign{1, 1, 1};
  double friction_in_n = 0.30;   ///< for motion in direction -z
  double friction_out_n = 0.45;  ///< for motion in direction +z
  double friction_x_n = 0.2;
  double weight_n = 0;   ///< pulls along -z
  bool blocked = false;  ///< held by a person or a spring scale
  bool silent = false;
  int noise_counts = 0;
  bool no_power = false;
  std::int64_t mute_from_ns = INT64_MAX;   ///< no sample from then on
  std::int64_t stuck_from_ns = INT64_MAX;  ///< no force arrives from then on

  Vector3 position_mm{3, 0, 10};
  Vector3 speed_mm_s;
  Vector3 last_share;
  double largest_share = 0;
  std::uint64_t number = 1;
  std::int64_t now_ns = 0;

  double counts(double mm) const {
    const int noise = noise_counts == 0 ? 0 : static_cast<int>(number % static_cast<std::uint64_t>(noise_counts + 1));
    return std::round(mm / mm_per_count) + noise;
  }
  DeviceState state() const {
    DeviceState out;
    out.number = number;
    out.time_ns = std::min(now_ns, mute_from_ns);
    out.written_ns = std::min(now_ns, stuck_from_ns);
    out.position_mm = {counts(position_mm.x), 0, counts(position_mm.z)};
    out.fault = DeviceFault::kNotCalibrated;
    return out;
  }
  static void slide(double& position_mm, double& speed_mm_s, double force_n, double friction_neg_n,
                    double friction_pos_n) {
    constexpr double kMassKg = 0.15;
    constexpr double kDampingNSMm = 0.02;  // so that a push does not throw the handle away
    if (speed_mm_s == 0 && force_n <= friction_pos_n && force_n >= -friction_neg_n) return;
    const bool positive = speed_mm_s > 0 || (speed_mm_s == 0 && force_n > 0);
    const double net_n = force_n - (positive ? friction_pos_n : -friction_neg_n) - kDampingNSMm * speed_mm_s;
    const double next = speed_mm_s + net_n / kMassKg * kCalibrationTickS * 1000;
    speed_mm_s = next * (positive ? 1 : -1) <= 0 ? 0 : next;
    position_mm += speed_mm_s * kCalibrationTickS;
  }
  void step(const Vector3& share) {
    last_share = share;
    largest_share = std::max(largest_share, std::sqrt(dot(share, share)));
    const double before = state().position_mm.z + state().position_mm.x;
    if (!blocked) {
      const double scale = no_power ? 0 : full_scale_n;
      slide(position_mm.x, speed_mm_s.x, sign.x * share.x * scale, friction_x_n, friction_x_n);
      slide(position_mm.z, speed_mm_s.z, sign.z * share.z * scale - weight_n, friction_in_n, friction_out_n);
    } else {
      speed_mm_s = {};
    }
    if (position_mm.z < -60) position_mm.z = -60;  // the end of the travel
    now_ns += 1'000'000;
    if (now_ns > mute_from_ns) return;
    if (!silent || state().position_mm.z + state().position_mm.x != before) ++number;
  }
  /// What a spring scale that holds it against moving outwards reads.
  double springScaleN() const { return sign.z * last_share.z * full_scale_n; }
};

/// A person who does what the procedure says.
class CalibrationPerson {
 public:
  CalibrationPerson(CalibrationPlan plan, UncalibratedDevice simulated)
      : device(simulated), procedure(std::move(plan)) {}

  void ticks(int count) {
    for (int i = 0; i < count; ++i) device.step(procedure.tick(device.state(), device.now_ns));
  }
  void untilNotIn(CalibrationStep step) {
    for (int i = 0; i < 100'000 && procedure.step() == step; ++i) ticks(1);
  }
  void proceed() {
    ticks(2);
    procedure.proceed();
    ticks(1);
  }
  void enter(double value) {
    const auto entered = procedure.enter(value);
    EXPECT_TRUE(entered) << entered.error().message();
    ticks(1);
  }
  void hold(double z_mm) {
    device.blocked = true;
    device.position_mm.z = z_mm;
    ticks(5);
  }
  void letGo() { device.blocked = false; }

  /// Up to the friction, both directions.
  void measureAllButTheScale() {
    EXPECT_EQ(procedure.step(), CalibrationStep::kLetGo);
    proceed();
    untilNotIn(CalibrationStep::kRest);
    untilNotIn(CalibrationStep::kSign);
    ASSERT_EQ(procedure.step(), CalibrationStep::kOuterEnd) << procedure.instruction();
    hold(20);
    proceed();
    ASSERT_EQ(procedure.step(), CalibrationStep::kInnerEnd);
    hold(-40);
    proceed();
    ASSERT_EQ(procedure.step(), CalibrationStep::kRuler) << procedure.instruction();
    enter(60);
    ASSERT_EQ(procedure.step(), CalibrationStep::kLetGoAgain);
    hold(0);
    letGo();
    proceed();
    untilNotIn(CalibrationStep::kFrictionIn);
    untilNotIn(CalibrationStep::kFrictionOut);
  }

  UncalibratedDevice device;
  CalibrationProcedure procedure;
};

inline CalibrationPlan samplePlan(ScaleMethod method = ScaleMethod::kSpringScale, bool both_axes = false) {
  return {"hid:1209:ffb0:7", "7", {both_axes, false, true}, method};
}

}  // namespace tactus::haptics
