#include "tests/vm/guided_calibration.h"

#include <string>

#include "core/haptics/servo/servo_clock.h"

namespace tactus::vm {
namespace {

using haptics::CalibrationInput;
using haptics::CalibrationProcedure;
using haptics::CalibrationStep;

constexpr int kLongestMs = 30'000;
constexpr double kMobility = 1000;  // counts per ms at full force: a light handle

class Person {
 public:
  Person(DeviceProcess& hand, const TrueHandle& truth) : hand_(hand), truth_(truth) {}

  /// As soon as a step begins.
  void prepare(CalibrationStep step) {
    switch (step) {
      case CalibrationStep::kLetGo:
      case CalibrationStep::kLetGoAgain: put(0.5); return letGo();
      case CalibrationStep::kOuterEnd: hold(); return put(0);
      case CalibrationStep::kInnerEnd: return put(1);
      case CalibrationStep::kScaleReady: return hold();
      default: return;
    }
  }

  base::Result<void> answer(CalibrationProcedure& procedure) {
    if (procedure.wanted() == CalibrationInput::kContinue) {
      procedure.proceed();
      return {};
    }
    if (procedure.step() == CalibrationStep::kRuler) return procedure.enter(truth_.travelMm());
    // The handle pulls at the spring scale with what its own friction leaves.
    const double pull_n = -truth_.newtons(hand_.force()) - truth_.friction_share * truth_.full_scale_n;
    return procedure.enter(pull_n);
  }

 private:
  void put(double share) {
    hand_.tell("at " + std::to_string(truth_.at(share)[0]) + " " + std::to_string(truth_.at(share)[1]));
  }
  void letGo() { hand_.tell("yields " + std::to_string(kMobility) + " " + std::to_string(truth_.friction_share)); }
  void hold() { hand_.tell("yields 0 0"); }

  DeviceProcess& hand_;
  const TrueHandle& truth_;
};

}  // namespace

base::Result<haptics::DeviceCalibration> calibrate(haptics::HapticDevice& device, DeviceProcess& hand,
                                                   const TrueHandle& truth) {
  CalibrationProcedure procedure(haptics::planFor(device.info()));
  Person person(hand, truth);
  auto step = CalibrationStep::kDone;
  int entered_ms = 0;
  std::int64_t due_ns = haptics::monotonicNs();
  for (int ms = 0; ms < kLongestMs && procedure.step() != CalibrationStep::kFailed; ++ms) {
    haptics::sleepUntil(due_ns += 1'000'000);
    const std::int64_t now_ns = haptics::monotonicNs();
    device.write(procedure.tick(device.read(now_ns), now_ns), now_ns);
    if (procedure.step() == CalibrationStep::kDone) return procedure.result("2026-01-01T00:00:00Z");
    if (procedure.step() != step) {
      step = procedure.step();
      entered_ms = ms;
      person.prepare(step);
    }
    const bool push = step == CalibrationStep::kScaleLow || step == CalibrationStep::kScaleHigh;
    if (procedure.wanted() == CalibrationInput::kNothing || ms - entered_ms < (push ? 700 : 50)) continue;
    if (auto taken = person.answer(procedure); !taken) return tl::unexpected(taken.error());
  }
  return base::fail(base::ErrorCode::kData, "calibration", procedure.instruction(), "a finished measurement");
}

}  // namespace tactus::vm
