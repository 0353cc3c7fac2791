// The guided measurement of a device with small forces: what a person does, what the device does, what comes out.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/haptics/device/device.h"
#include "core/haptics/device/device_calibration.h"
#include "core/haptics/device/driven_axes.h"

namespace tactus::haptics {

/// How the newtons at full scale are found.
enum class ScaleMethod : std::uint8_t {
  kSpringScale,  ///< two readings of a spring scale: their difference is free of friction
  kKnownWeight,  ///< the force that lifts a known weight
};

/// What the procedure is to measure. The axes are those of the device's frame: x, y, z.
struct CalibrationPlan {
  std::string device;
  std::string serial;
  DrivenAxes driven{};  ///< axes along which the device can push; at least one
  ScaleMethod method = ScaleMethod::kSpringScale;
};

/// The plan for a device with `info.force_axes` motors.
CalibrationPlan planFor(const DeviceInfo& info);

enum class CalibrationStep : std::uint8_t {
  kLetGo,        ///< waits for the person
  kRest,         ///< noise, and whether the device reports while nothing moves
  kSign,         ///< a short push along each driven axis
  kOuterEnd,     ///< waits: the handle where the tube begins
  kInnerEnd,     ///< waits: the handle moved inwards
  kRuler,        ///< waits for millimetres
  kLetGoAgain,   ///< waits
  kFrictionIn,   ///< a rising push inwards until it moves
  kFrictionOut,  ///< the same outwards
  kWeight,       ///< waits for newtons
  kLift,         ///< a rising push outwards until the weight moves
  kScaleReady,   ///< waits: the spring scale is in place
  kScaleLow,     ///< waits for newtons at the small push
  kScaleHigh,    ///< waits for newtons at the larger push
  kDone,
  kFailed,
};

/// What the person has to give before it goes on.
enum class CalibrationInput : std::uint8_t { kNothing, kContinue, kNumber };

/// A state machine without clock, thread or device. The device is used without a calibration: positions come as counts
/// and 1 N means full scale. No push is larger than kLargestShare, and each ends as soon as the handle moves. Pushes go
/// along the motors; where the insertion axis leaves them by some degrees, the full scale is that along the motors, and
/// the friction that along the axis. Positions, and forces that reached the device, may be 0.2 s old at most; of a
/// device that is silent when still only the forces. Thread: one. Real-time safe: no.
class CalibrationProcedure {
 public:
  static constexpr double kLargestShare = 0.25;
  static constexpr double kSignShare = 0.05;
  static constexpr double kSignS = 0.05;
  static constexpr double kLowShare = 0.1;
  static constexpr double kHighShare = 0.2;
  static constexpr double kRiseShareS = 0.02;  ///< slow enough that the first motion is that of dry friction

  explicit CalibrationProcedure(CalibrationPlan plan);

  /// The force to ask the device for now. `raw.position_mm` holds counts; `now_ns` never goes back.
  Vector3 tick(const DeviceState& raw, std::int64_t now_ns);

  CalibrationStep step() const { return step_; }
  CalibrationInput wanted() const;
  /// What to do now, for a person; after a failure what went wrong.
  const std::string& instruction() const { return instruction_; }

  /// The person pressed Continue; without effect where it is not wanted.
  void proceed();
  /// The person typed a number. Refused: none is wanted, or it cannot be.
  base::Result<void> enter(double value);
  void cancel();

  /// After kDone. `measured_at`: see DeviceCalibration. Refused: not done, or numbers that cannot be.
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
  int samples_ = 0;  ///< of the device, since the step began
  std::string instruction_;
  std::int64_t now_ns_ = 0;
  std::int64_t step_ns_ = 0;
  Counts at_{};
  Counts start_{};  ///< where the handle was at the beginning of a step
  std::uint64_t sample_ = 0;

  Counts lowest_{};
  Counts highest_{};
  double threshold_ = 0;  ///< counts that are motion and no noise
  std::size_t axis_ = 0;
  double sign_share_ = 0;
  std::array<double, 3> signs_{1, 1, 1};
  Counts outer_{};
  Counts travel_{};
  Vector3 inwards_;
  Vector3 drive_;            ///< unit: the part of the axis that the device can push along
  double driven_share_ = 1;  ///< cosine between the two
  double mm_per_count_ = 0;
  std::optional<double> friction_in_;  ///< shares
  std::optional<double> friction_out_;
  double weight_n_ = 0;
  double low_n_ = 0;
  double full_scale_n_ = 0;
};

}  // namespace tactus::haptics
