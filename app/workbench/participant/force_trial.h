// One step of the force part: the pause, the force in the hand, and what is measured of it until the answer.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "app/workbench/device/device_session.h"
#include "core/haptics/servo/stimulus_delivery.h"
#include "experiments/force_protocol.h"
#include "experiments/stroke.h"

namespace tactus::workbench {

/// A step may be felt more than once. Each time the device rests first, as long as the protocol and the heat of its
/// motors ask for. The answer is about all of them: forward motion of the time with the longest way, and delivered only
/// if each of them was; its share is the least of them. Thread: gui.
class ForceTrial {
 public:
  enum class Phase {
    kNone,
    kPause,  ///< without force
    kWait,   ///< ordered; it begins when the hand holds the handle at the start
    kRise,
    kFelt,  ///< the full force was reached: an answer may be given, also after the force has ended
  };

  explicit ForceTrial(DeviceSession& device) : device_(device) {}

  /// Begins the pause before the step. The device must be running.
  void begin(const experiments::ForcePlan& plan);
  /// Again, with the pause first. Only after it was felt.
  void feelAgain();
  /// No force; forgets the step.
  void cancel();

  /// All samples, oldest first. Returns whether the phase changed.
  bool add(std::span<const haptics::Sample> samples);

  Phase phase() const { return phase_; }
  bool wasFelt() const { return felt_once_; }
  /// The pause lasts longer than the protocol asks, because the motors are warm.
  bool isWarm() const { return warm_; }

  /// What was measured so far, without the word. `wasFelt` must be true.
  experiments::ForceAnswer measured() const;

 private:
  void pause();
  double restS() const;
  void take(const haptics::Sample& sample);
  void order();

  DeviceSession& device_;
  experiments::ForcePlan plan_;
  Phase phase_ = Phase::kNone;
  std::uint64_t number_ = 0;  ///< of the stimulus; never used twice
  std::uint64_t orders_ = 0;  ///< samples with older orders are not of this stimulus
  bool warm_ = false;
  std::optional<std::int64_t> pause_since_ns_;
  std::int64_t full_ns_ = 0;
  bool felt_once_ = false;
  int again_ = 0;
  haptics::StimulusDelivery delivery_;
  std::optional<experiments::ForwardMotion> motion_;
  double since_full_s_ = 0;
  // Of the times before this one.
  bool delivered_before_ = true;
  std::optional<double> share_before_ = 1;
  double way_before_mm_ = 0;
  double speed_before_mm_s_ = 0;
};

}  // namespace tactus::workbench
