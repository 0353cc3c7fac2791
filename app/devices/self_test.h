// The guided self-test of a haptic device: what is asked of the person, what is checked, what it found. A pure state
// machine: samples of the servo and answers of the person in, orders for the servo and sentences out.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/haptics/safety/trip.h"
#include "core/haptics/servo/sample.h"
#include "core/haptics/servo/servo_orders.h"

namespace tactus::devices {

struct SelfTestSettings {
  haptics::AxisMapping axis;
  haptics::LimitSettings limits;  ///< all of them hold; the test needs `pulse_n` of their cap
  double pulse_n = 0.1;           ///< felt in the fingers, too small to move the hand by much
  int pulses = 3;
  double move_mm = 20;              ///< how far the person has to move the device
  double most_drift_mm = 5;         ///< while it is held without force
  double farthest_mm = 1000;        ///< a position further out is none
  double smallest_shift_mm = 0.15;  ///< a shift of the hand by less is no answer; use two counts where they are more
  double patience_s = 60;           ///< for each thing that the person is asked to do
  std::string calibration_advice;   ///< what to do about a device without calibration
  std::string axis_advice;          ///< how to turn the insertion axis around; may be empty
};

/// In this order.
enum class Check : std::uint8_t {
  kSamples,      ///< samples arrive, are fresh, and the position is one
  kCalibration,  ///< the device says that its positions mean something
  kMotion,       ///< the position follows the hand, inwards positive
  kButton,       ///< a button arrives, down and up
  kForceOff,     ///< held with force 0 the hand stays where it is
  kPulse,        ///< a small force passes all limits
  kDirection,    ///< it pulls against insertion, toward the person
};
inline constexpr int kChecks = 7;
/// e.g. `samples arrive`.
std::string_view describe(Check check) noexcept;

struct CheckResult {
  Check check = Check::kSamples;
  bool passed = false;
  std::string found;   ///< what was seen, with numbers
  std::string advice;  ///< what to do; empty where it passed
};

/// What the person felt.
enum class Felt : std::uint8_t { kToward, kAway, kNothing };

/// Ends after the first check that fails: the next ones would mean nothing.
class SelfTest {
 public:
  enum class Phase : std::uint8_t { kSamples, kMotion, kButton, kForceOff, kPulse, kAsk, kDone };

  explicit SelfTest(SelfTestSettings settings);

  /// New orders for the servo, once each; nothing: those in force stay. Tell `posted` their number.
  std::optional<haptics::ServoOrders> takeOrders();
  void posted(std::uint64_t orders) noexcept { orders_ = orders; }

  /// One sample of the servo, all of them in order. Those from before the newest orders are left out.
  void feed(const haptics::Sample& sample);
  /// The servo tripped; the test ends.
  void tripped(const haptics::Trip& trip);
  /// The person's answer, in the phase kAsk.
  void answer(Felt felt);
  /// Ends the test without a result of the present check; the last orders are those for no force.
  void cancel();

  Phase phase() const noexcept { return phase_; }
  bool finished() const noexcept { return phase_ == Phase::kDone; }
  /// Every check passed.
  bool passed() const noexcept;
  /// What the person is to do now: one sentence, empty where there is nothing to do.
  std::string instruction() const;
  const std::vector<CheckResult>& results() const noexcept { return results_; }
  /// The largest shift of the hand that a pulse made, mm, inwards positive; 0 before the first. Dry friction holds the
  /// hand where the first pulse has left it, so the others can be smaller.
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
    int rest = 0;          ///< ticks to wait
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
  std::uint64_t orders_ = 0;  ///< samples from before these say nothing
  Seen seen_;
  Held held_;
  int tries_ = 0;            ///< of the force-off check, or of pulses that were cut short
  double drift_mm_ = 0;      ///< of the last try
  std::uint64_t pulse_ = 0;  ///< number of the stimulus
  double largest_force_n_ = 0;
  std::vector<double> shifts_mm_;
};

}  // namespace tactus::devices
