// What the self-test says: to the person, and about what ended it.
#include "app/devices/self_test.h"
#include "core/base/text.h"

namespace tactus::devices {
namespace {

using base::formatFixed;
using base::formatNumber;
using haptics::DeviceFault;
using haptics::TripCause;

std::string millimeters(double value_mm) { return formatFixed(value_mm, 2) + " mm"; }

std::string_view faultAdvice(DeviceFault fault) {
  switch (fault) {
    case DeviceFault::kSwitchedOff:
      return "switch the forces on at the device, and close other programs that use it";
    case DeviceFault::kWarmMotors:
      return "let it cool down for some minutes";
    default:
      return "unplug it, plug it in again, and repeat the test";
  }
}

DeviceFault faultOf(const haptics::Trip& trip) { return static_cast<DeviceFault>(static_cast<int>(trip.value)); }

}  // namespace

std::string_view describe(Check check) noexcept {
  constexpr std::string_view kTexts[kChecks] = {"samples arrive", "calibrated",  "position follows the hand", "button",
                                                "no force",       "small force", "direction of the force"};
  return kTexts[static_cast<int>(check)];
}

std::string_view SelfTest::name(Phase phase) noexcept {
  constexpr std::string_view kNames[] = {"samples", "motion", "button", "force_off", "pulse", "ask", "done"};
  return kNames[static_cast<int>(phase)];
}

std::string SelfTest::instruction() const {
  switch (phase_) {
    case Phase::kMotion:
      return "Move the handle about 5 cm away from you, then back.";
    case Phase::kButton:
      return "Press a button of the handle and let it go.";
    case Phase::kForceOff:
      return "Hold the handle loosely and still. Press the button and keep it pressed.";
    case Phase::kPulse:
      return "Keep the button pressed. You will feel " + std::to_string(settings_.pulses) + " soft pulls of " +
             formatNumber(settings_.pulse_n) + " N.";
    case Phase::kAsk:
      return "Did it pull toward you, push away from you, or did you feel nothing?";
    default:
      return {};
  }
}

void SelfTest::tripped(const haptics::Trip& trip) {
  if (finished()) return;
  const bool fault = trip.cause == TripCause::kDeviceFault;
  if (fault && faultOf(trip) == DeviceFault::kNotCalibrated)
    return fail(Check::kCalibration, haptics::sentence(trip), settings_.calibration_advice);
  if (fault) return fail(current(), haptics::sentence(trip), std::string(faultAdvice(faultOf(trip))));
  fail(current(), haptics::sentence(trip), "check the cable and the power supply of the device, then repeat the test");
}

void SelfTest::lostPatience() {
  const std::string waited = " within " + formatNumber(settings_.patience_s) + " s";
  switch (phase_) {
    case Phase::kMotion:
      return fail(Check::kMotion,
                  "moved by " + millimeters(seen_.inwards_mm) + " inwards and " + millimeters(seen_.outwards_mm) +
                      " outwards" + waited,
                  "move it at least " + formatNumber(settings_.move_mm) + " mm away from you and back");
    case Phase::kButton:
      return fail(Check::kButton, (seen_.button_up ? "no press and release" : "a button that stays down") + waited,
                  "press a button of the device; without one it cannot be used");
    case Phase::kForceOff:
      return fail(Check::kForceOff, "the button was not held for 1.3 s" + waited,
                  "press the button and keep it pressed");
    default:
      return fail(current(), "no end" + waited, "press the button and keep it pressed");
  }
}

}  // namespace tactus::devices
