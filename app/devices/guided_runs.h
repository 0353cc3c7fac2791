// Runs the guided self-test and the guided calibration of a device.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/haptics/device/calibration_procedure.h"
#include "core/haptics/device/device.h"
#include "core/haptics/safety/safety.h"
#include "core/haptics/servo/sample.h"
#include "core/haptics/servo/servo_core.h"
#include "core/haptics/simulated/virtual_device.h"

namespace tactus::devices {

// The guided self-test of a haptic device: its instructions, checks and results. A pure state machine: servo samples
// and the person's answers go in; servo orders and sentences come out.

struct SelfTestSettings {
  haptics::AxisMapping axis;
  haptics::LimitSettings limits;  ///< all limits hold; the test needs `pulse_n` of their cap
  double pulse_n = 0.1;           ///< enough to feel with the fingers, too little to move the hand far
  int pulses = 3;
  double move_mm = 20;              ///< how far the person must move the device
  double most_drift_mm = 5;         ///< largest drift while the hand holds the device without force
  double farthest_mm = 1000;        ///< a position beyond this is invalid
  double smallest_shift_mm = 0.15;  ///< a smaller shift of the hand is no answer; for coarse devices use two counts
  double patience_s = 60;           ///< time limit for each instruction
  std::string calibration_advice;   ///< what to do about a device without calibration
  std::string axis_advice;          ///< how to reverse the insertion axis; may be empty
};

/// The checks, in this order.
enum class Check : std::uint8_t {
  kSamples,      ///< fresh samples arrive, with a valid position
  kCalibration,  ///< the device reports that it is calibrated
  kMotion,       ///< the position follows the hand, inward positive
  kButton,       ///< a button changes: down and up
  kForceOff,     ///< with force 0 the hand stays in place
  kPulse,        ///< a small force passes all limits
  kDirection,    ///< the force pulls against insertion, toward the person
};
inline constexpr int kChecks = 7;
/// e.g. `samples arrive`.
std::string_view describe(Check check) noexcept;

struct CheckResult {
  Check check = Check::kSamples;
  bool passed = false;
  std::string found;   ///< the observation, with numbers
  std::string advice;  ///< what to do; empty if the check passed
};

/// The direction that the person felt.
enum class Felt : std::uint8_t { kToward, kAway, kNothing };

/// Ends after the first failed check, because later checks would be meaningless.
class SelfTest {
 public:
  enum class Phase : std::uint8_t { kSamples, kMotion, kButton, kForceOff, kPulse, kAsk, kDone };

  /// `samples`, `motion`, `button`, `force_off`, `pulse`, `ask`, `done`: for screens that have instructions of their
  /// own in several languages, without numbers.
  static std::string_view name(Phase phase) noexcept;

  explicit SelfTest(SelfTestSettings settings);

  /// New orders for the servo, each returned once; nothing: the current orders stay. Report their number with `posted`.
  std::optional<haptics::ServoOrders> takeOrders();
  void posted(std::uint64_t orders) noexcept { orders_ = orders; }

  /// Processes one servo sample; call for all samples in order. Samples from before the newest orders are ignored.
  void feed(const haptics::Sample& sample);
  /// The servo tripped: the test ends.
  void tripped(const haptics::Trip& trip);
  /// The person's answer, in the phase kAsk.
  void answer(Felt felt);
  /// Ends the test without a result of the current check. The last orders are for zero force.
  void cancel();

  Phase phase() const noexcept { return phase_; }
  bool finished() const noexcept { return phase_ == Phase::kDone; }
  /// Every check passed.
  bool passed() const noexcept;
  /// The current instruction for the person: one sentence; empty if there is none.
  std::string instruction() const;
  const std::vector<CheckResult>& results() const noexcept { return results_; }
  /// The largest shift of the hand by a pulse, mm, inward positive; 0 before the first pulse. Dry friction holds the
  /// hand where the first pulse has left it, so later shifts can be smaller.
  double shiftMm() const;

 private:
  /// The mean of positions over some ticks.
  struct Mean {
    double sum_mm = 0;
    int count = 0;
    void add(double position_mm) noexcept {
      sum_mm += position_mm;
      ++count;
    }
    double mm() const noexcept { return count > 0 ? sum_mm / count : 0; }
  };

  /// What was seen since the phase began.
  struct Seen {
    std::int64_t since_ns = 0;  ///< time of its first sample
    int ticks = 0;
    std::int64_t oldest_ns = 0;
    double start_mm = 0;
    double inwards_mm = 0;
    double outwards_mm = 0;
    bool button_up = false;
    std::uint32_t button = 0;
  };

  /// A stretch of time in which the hand holds the device.
  struct Held {
    int ticks = 0;
    Mean before;
    Mean after;
    bool pulsing = false;  ///< the stimulus has been ordered
    int rest = 0;          ///< ticks until the next action
  };

  void enter(Phase phase);
  void order(haptics::ForceSource source);
  void pass(Check check, std::string found);
  void fail(Check check, std::string found, std::string advice);
  Check current() const noexcept;

  void checkSamples(const haptics::Sample& sample);
  void checkMotion(const haptics::Sample& sample);
  void checkButton(const haptics::Sample& sample);
  void checkForceOff(const haptics::Sample& sample);
  void checkPulse(const haptics::Sample& sample);
  void pulseEnded();
  bool clearlyInwards() const;
  void lostPatience();

  SelfTestSettings settings_;
  Phase phase_ = Phase::kSamples;
  std::vector<CheckResult> results_;
  std::optional<haptics::ServoOrders> next_;
  std::uint64_t orders_ = 0;  ///< samples from before these orders are ignored
  Seen seen_;
  Held held_;
  int tries_ = 0;            ///< of the force-off check, or of interrupted pulses
  double drift_mm_ = 0;      ///< of the last try
  std::uint64_t pulse_ = 0;  ///< number of the stimulus
  double largest_force_n_ = 0;
  std::vector<double> shifts_mm_;
};

// Runs the guided calibration of a device, or waits for the calibration by its driver.

/// The person at the device.
class CalibrationGuide {
 public:
  virtual ~CalibrationGuide() = default;
  virtual void instruct(const std::string& sentence) = 0;
  /// Shows a sentence about a refused answer.
  virtual void refuse(const std::string& sentence) = 0;
  /// The answer to the last instruction, returned once; nothing: no answer yet. Must return quickly, because the device
  /// is pushing. The answer `stop` ends the procedure.
  virtual std::optional<std::string> answer() = 0;
  /// Whether the program must end (Ctrl-C). Checked in every millisecond. If true, the device is stopped and the run
  /// refused.
  virtual bool interrupted() const noexcept { return false; }
};

/// A clock, and a wait for the next millisecond. Tests replace both.
struct CalibrationClock {
  std::int64_t (*now_ns)() noexcept;
  void (*sleep_until)(std::int64_t time_ns) noexcept;
};
/// The clock of the servo.
CalibrationClock systemClock() noexcept;

/// Starts the device, guides the person through the procedure and stops the device. Refused: the device does not start
/// or disconnects, the procedure fails, the person stops or interrupts it. `measured_at`: UTC.
base::Result<haptics::DeviceCalibration> runCalibration(haptics::HapticDevice& device,
                                                        const haptics::CalibrationPlan& plan,
                                                        const std::string& measured_at, CalibrationGuide& guide,
                                                        const CalibrationClock& clock = systemClock());

/// For a device that its own driver calibrates (OpenHaptics, Haply): instructs the person and waits until the driver
/// reports the calibration. An answer tells the driver that the device is in its reference posture. Refused: a device
/// of another kind, a device that does not start, a person who stops or interrupts.
base::Result<void> calibrateByDriver(haptics::HapticDevice& device, CalibrationGuide& guide,
                                     const CalibrationClock& clock = systemClock());

// Runs the self-test on a device: on the servo in real time, or in virtual time for a simulated device.

/// The person at the device.
class SelfTestGuide {
 public:
  virtual ~SelfTestGuide() = default;
  virtual void instruct(const std::string& sentence) = 0;
  virtual void tell(const CheckResult& result) = 0;
  /// Asks the question; may wait without limit. Meanwhile the program sends no heartbeat, so the servo gives no force.
  virtual Felt ask(const std::string& question) = 0;
  /// Whether the program must end (Ctrl-C). Checked every few milliseconds; the value of `ask` is then ignored.
  virtual bool interrupted() const noexcept { return false; }
};

/// Starts the device, runs the test on a servo thread (or in the driver's loop) and stops the device. Returns the
/// finished test. Refused: the device or the thread does not start; the person interrupts (the device is then stopped).
base::Result<SelfTest> runSelfTest(haptics::HapticDevice& device, const SelfTestSettings& settings,
                                   SelfTestGuide& guide);

/// The same in virtual time. A simulated person also answers the question; the guide gets all messages but no
/// questions. `device` must have a live hand.
base::Result<SelfTest> simulateSelfTest(haptics::VirtualDevice& device, const SelfTestSettings& settings,
                                        SelfTestGuide& guide);

/// Calls the function of the two that fits the device.
base::Result<SelfTest> selfTest(haptics::HapticDevice& device, const SelfTestSettings& settings, SelfTestGuide& guide);

/// The settings for a device: its limits, and a shift larger than its counts.
SelfTestSettings settingsFor(const haptics::DeviceInfo& info);

}  // namespace tactus::devices
