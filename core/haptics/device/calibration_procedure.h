// The guided measurement of a device with small forces: instructions to the user, forces of the device, and the result.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/haptics/device/calibration_file.h"
#include "core/haptics/device/device.h"

namespace tactus::haptics {

/// The way to find the force at full scale.
enum class ScaleMethod : std::uint8_t {
  kSpringScale,  ///< two readings of a spring scale; friction cancels in their difference
  kKnownWeight,  ///< the force that lifts a known weight
};

/// The scope of the procedure. Axes are those of the device's frame: x, y, z.
struct CalibrationPlan {
  std::string device;
  std::string serial;
  DrivenAxes driven{};  ///< axes along which the device can push; at least one
  ScaleMethod method = ScaleMethod::kSpringScale;
};

/// The plan for a device with `info.force_axes` motors.
CalibrationPlan planFor(const DeviceInfo& info);

enum class CalibrationStep : std::uint8_t {
  kLetGo,        ///< waits until the user has let go
  kRest,         ///< measures the noise, and whether the device reports at rest
  kSign,         ///< a short push along each driven axis
  kOuterEnd,     ///< waits until the handle is where the tube begins
  kInnerEnd,     ///< waits until the user has moved the handle inwards
  kRuler,        ///< waits for the distance in mm
  kLetGoAgain,   ///< waits until the user has let go
  kFrictionIn,   ///< a rising push inwards until the handle moves
  kFrictionOut,  ///< a rising push outwards until the handle moves
  kWeight,       ///< waits for the weight in N
  kLift,         ///< a rising push outwards until the weight moves
  kScaleReady,   ///< waits until the spring scale is in place
  kScaleLow,     ///< waits for the reading in N at the small push
  kScaleHigh,    ///< waits for the reading in N at the larger push
  kDone,
  kFailed,
};

/// The input that the current step needs from the user.
enum class CalibrationInput : std::uint8_t { kNothing, kContinue, kNumber };

/// A state machine without clock, thread or device. The caller uses the device without a calibration: positions are
/// counts, and 1 N means full scale.
/// No push exceeds kLargestShare, and each ends as soon as the handle moves. The device pushes along its motors. If the
/// insertion axis is inclined to them by some degrees, the full scale applies along the motors and the friction along
/// the axis.
/// A position, and the last force that reached the device, may be at most 0.2 s old. For a device that is silent at
/// rest, only the age of the force counts.
/// Thread: one. Real-time safe: no.
class CalibrationProcedure {
 public:
  static constexpr double kLargestShare = 0.25;
  static constexpr double kSignShare = 0.05;
  static constexpr double kSignS = 0.05;
  static constexpr double kLowShare = 0.1;
  static constexpr double kHighShare = 0.2;
  static constexpr double kRiseShareS = 0.02;  ///< slow, so that dry friction alone delays the first motion

  explicit CalibrationProcedure(CalibrationPlan plan);

  /// Returns the force to write to the device now. `raw.position_mm`: counts. `now_ns`: never decreases.
  Vector3 tick(const DeviceState& raw, std::int64_t now_ns);

  CalibrationStep step() const { return step_; }
  CalibrationInput wanted() const;
  /// The instruction for the user, or the reason of a failure.
  const std::string& instruction() const { return instruction_; }

  /// Call when the user has pressed Continue. No effect if the step does not wait for it.
  void proceed();
  /// Call when the user has typed a number. Returns an error if the step needs no number or the number is impossible.
  base::Result<void> enter(double value);
  void cancel();

  /// The result, after kDone. `measured_at`: see DeviceCalibration. Returns an error before kDone, or if the numbers
  /// are impossible.
  base::Result<DeviceCalibration> result(const std::string& measured_at) const;

 private:
  using Counts = std::array<double, 3>;

  void go(CalibrationStep step);
  void failWith(std::string sentence);
  void say(std::string sentence) { instruction_ = std::move(sentence); }
  double elapsedS() const { return static_cast<double>(now_ns_ - step_ns_) * 1e-9; }
  double movedFromStart() const;
  Vector3 push(double share) const;

  void lookAtAges(const DeviceState& raw);
  Vector3 rest();
  Vector3 sign();
  Vector3 rising(double direction);
  Vector3 held(double share);
  void beginPushAlong(std::size_t axis, double share);
  void takeInnerEnd();
  std::string scaleDirection() const;
  base::Result<void> finishWithReadings(double high_n);

  CalibrationPlan plan_;
  CalibrationStep step_ = CalibrationStep::kLetGo;
  bool just_entered_ = true;
  bool sign_seen_ = false;
  bool silent_ = false;
  int samples_ = 0;  ///< of the device, since the start of the step
  std::string instruction_;
  std::int64_t now_ns_ = 0;
  std::int64_t step_ns_ = 0;
  Counts at_{};
  Counts start_{};  ///< position of the handle at the start of a step
  std::uint64_t sample_ = 0;

  Counts lowest_{};
  Counts highest_{};
  double threshold_ = 0;  ///< counts; a larger change is motion, a smaller one noise
  std::size_t axis_ = 0;
  double sign_share_ = 0;
  std::array<double, 3> signs_{1, 1, 1};
  Counts outer_{};
  Counts travel_{};
  Vector3 inwards_;
  Vector3 drive_;            ///< unit vector: the direction of the axis projected on the motors
  double driven_share_ = 1;  ///< cosine of the angle between the two
  double mm_per_count_ = 0;
  std::optional<double> friction_in_;  ///< shares
  std::optional<double> friction_out_;
  double weight_n_ = 0;
  double low_n_ = 0;
  double full_scale_n_ = 0;
};

}  // namespace tactus::haptics
