#include "app/devices/calibration_run.h"

#include "core/base/text.h"
#include "core/haptics/openhaptics/openhaptics_device.h"
#include "core/haptics/servo/servo_clock.h"

namespace tactus::devices {
namespace {

using haptics::CalibrationInput;
using haptics::CalibrationProcedure;
using haptics::CalibrationStep;

constexpr std::int64_t kSampleNs = 1'000'000;
constexpr int kDriverTicks = 500;  ///< a driver calibrates in its next frame, or not at all

/// Hands the person's answer over, if there is one.
void takeAnswer(CalibrationProcedure& procedure, CalibrationGuide& guide) {
  if (procedure.wanted() == CalibrationInput::kNothing) return;
  const auto answer = guide.answer();
  if (!answer) return;
  const std::string_view text = base::trimmed(*answer);
  if (text == "stop") return procedure.cancel();
  if (procedure.wanted() == CalibrationInput::kContinue) return procedure.proceed();
  const auto number = base::parseNumber(text);
  if (!number) return guide.refuse("found " + base::quoted(text) + ", wanted a number such as 1.5, or stop");
  if (const auto taken = procedure.enter(*number); !taken) guide.refuse(taken.error().message());
}

tl::unexpected<base::Error> interruption(const haptics::HapticDevice& device) {
  return base::fail(base::ErrorCode::kCancelled, device.info().id, "an interruption, and the device was stopped",
                    "a complete calibration");
}

/// Ticks until the procedure ends. The device has no force when this returns.
base::Result<void> lead(haptics::HapticDevice& device, CalibrationProcedure& procedure, CalibrationGuide& guide,
                        const CalibrationClock& clock) {
  std::string told;
  for (std::int64_t due_ns = clock.now_ns();; due_ns += kSampleNs) {
    clock.sleep_until(due_ns);
    const std::int64_t now_ns = clock.now_ns();
    if (guide.interrupted()) {
      device.write({}, now_ns);
      return interruption(device);
    }
    const haptics::DeviceState state = device.read(now_ns);
    const bool lost = state.fault == haptics::DeviceFault::kLost;
    device.write(lost ? haptics::Vector3{} : procedure.tick(state, now_ns), now_ns);
    if (lost)
      return base::fail(base::ErrorCode::kIo, device.info().id, "the device is gone", "a device that stays plugged in");
    if (procedure.step() == CalibrationStep::kDone || procedure.step() == CalibrationStep::kFailed) break;
    if (procedure.instruction() == told) {
      takeAnswer(procedure, guide);
      continue;
    }
    told = procedure.instruction();
    guide.instruct(told);
  }
  device.write({}, clock.now_ns());
  if (procedure.step() == CalibrationStep::kDone) return {};
  return base::fail(base::ErrorCode::kData, device.info().id, procedure.instruction(), "a calibration that ends well");
}

}  // namespace

CalibrationClock systemClock() noexcept { return {haptics::monotonicNs, haptics::sleepUntil}; }

base::Result<haptics::DeviceCalibration> runCalibration(haptics::HapticDevice& device,
                                                        const haptics::CalibrationPlan& plan,
                                                        const std::string& measured_at, CalibrationGuide& guide,
                                                        const CalibrationClock& clock) {
  if (const auto started = device.start(); !started) return tl::unexpected(started.error());
  CalibrationProcedure procedure(plan);
  const auto led = lead(device, procedure, guide, clock);
  device.stop();
  if (!led) return tl::unexpected(led.error());
  return procedure.result(measured_at);
}

base::Result<void> calibrateByDriver(haptics::HapticDevice& device, CalibrationGuide& guide,
                                     const CalibrationClock& clock) {
  auto* const driven = dynamic_cast<haptics::OpenHapticsDevice*>(&device);
  if (driven == nullptr)
    return base::fail(base::ErrorCode::kReference, device.info().id, "a device without a calibration",
                      "a HID device or one behind OpenHaptics");
  if (auto started = driven->start(); !started) return started;
  if (!driven->calibrated()) guide.instruct("To calibrate, " + driven->calibrationAdvice() + ": then press Enter.");
  bool stopped = false;
  while (!driven->calibrated() && !stopped && !guide.interrupted()) {
    clock.sleep_until(clock.now_ns() + kSampleNs);
    const auto answer = guide.answer();
    if (!answer) continue;
    stopped = base::trimmed(*answer) == "stop";
    if (stopped) continue;
    driven->requestCalibration();
    for (int waited = 0; waited < kDriverTicks && !driven->calibrated() && !guide.interrupted(); ++waited)
      clock.sleep_until(clock.now_ns() + kSampleNs);
    if (!driven->calibrated() && !guide.interrupted())
      guide.refuse("The driver did not take it. Try again, or type stop.");
  }
  const bool calibrated = driven->calibrated();
  driven->stop();
  if (calibrated) return {};
  if (guide.interrupted()) return interruption(device);
  return base::fail(base::ErrorCode::kCancelled, device.info().id, "no calibration", driven->calibrationAdvice());
}

}  // namespace tactus::devices
