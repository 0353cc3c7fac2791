// The course of the nurse's screens without state of its own: which one is shown, which follows from the stored records
// and from what she has passed since she sat down; and what the device steps measure in her hand: the check, the wait
// for a grip, one force until its answer, her own model.
#pragma once

#include <QObject>
#include <QPointF>
#include <QString>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "app/session/session_notes.h"
#include "app/workbench/device/device_session.h"
#include "app/workbench/participant/kit/participant_state.h"
#include "app/workbench/study/connection/study_connection.h"
#include "app/workbench/study/connection/study_contents.h"
#include "core/base/error.h"
#include "core/haptics/servo/sample.h"
#include "core/haptics/servo/stimulus_delivery.h"
#include "core/haptics/sources/servo_scene.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"
#include "experiments/force_protocol.h"
#include "experiments/stroke.h"

namespace tactus::workbench {

// Her own model in the hand, region by region: built from her answers, kept in the study, and what she says of it
// (own_model_trial.cpp).

/// A region of the way: the depth from which it is felt, to its end.
struct OwnRegion {
  std::string id;  ///< term id of the depth
  double from_mm = 0;
  double to_mm = 0;
};

/// Immutable.
struct OwnModel {
  std::shared_ptr<const haptics::ServoScene> scene;
  haptics::Conditions conditions;  ///< at which it is felt
  std::vector<OwnRegion> regions;  ///< along the way
  /// What a sample's depth lacks to the depth of the model, mm.
  double depthOffsetMm() const { return scene->renderer().depth_offset_mm; }
  /// As the study keeps it, without its id. Its label (session::kOwnModelLabel) tells it from the versions of the
  /// researcher's model.
  study::ModelVersion version;
  std::vector<QPointF> curve;  ///< depth in mm, share of the largest force; at the scene's conditions
};

/// Builds the model of the participant `code` from the study, under the conditions that its procedure names for it
/// (InputNotes::own_model). Refused: no rules follow from her answers, or the servo
/// refuses the model. Thread: that of `file`.
base::Result<OwnModel> ownModel(const store::StudyFile& file, const std::string& code);

/// Thread: gui.
class OwnModelTrial : public QObject {
  Q_OBJECT

 public:
  /// Both outlive this. `device_scale`: of the procedure.
  OwnModelTrial(StudyConnection& study, DeviceSession& device, double device_scale)
      : study_(study), device_(device), device_scale_(device_scale) {}

  /// Builds the model of the participant `code` and stores it as a version of its own; does nothing if that was asked
  /// before. Ends with `changed`.
  void prepare(const std::string& code);
  bool isThere() const { return model_ != nullptr; }
  /// Puts the region into the device. The model is there, and the device runs.
  void feel();
  /// All samples: the place of a mark is where the hand was last.
  void look(std::span<const haptics::Sample> samples);

  std::size_t region() const { return region_; }
  /// A mark at the last place in the hand.
  session::Note mark();
  /// She pushed far enough under the force of this region to compare it.
  bool wasFelt() const { return pushed_mm_ >= kFeltMm; }
  static constexpr double kFeltMm = 20;
  /// What she says of the region: `lighter`, `right`, `heavier`, `cant_tell`. Goes to the next region.
  session::Note say(const QString& comparison);
  /// All regions were felt.
  bool isDone() const { return done_; }

  /// Without what is chosen on the screen. `runs`: the device does.
  OwnModelState state(bool runs) const;
  /// Depth in mm, share of the largest force; empty: no model.
  const std::vector<QPointF>& curve() const;

 signals:
  void changed();

 private:
  session::OwnModelPlace place() const;

  StudyConnection& study_;
  DeviceSession& device_;
  double device_scale_;
  bool asked_ = false;
  std::shared_ptr<const OwnModel> model_;
  QString refused_;
  std::size_t region_ = 0;
  bool done_ = false;
  int marks_ = 0;
  std::optional<haptics::Sample> felt_;  ///< the last one with the handle in the hand, in this region
  std::optional<double> pushed_from_mm_;
  double pushed_mm_ = 0;  ///< from the shallowest place of the hand in this region, forward
};

// The device check before the first insertion: hold the handle, keep still, push gently, let go. No force is given.

/// The handle must be let go before it counts as held, so a stuck button is found. Plain state. Thread: gui.
class DeviceCheck {
 public:
  static constexpr double kStillS = 1;   ///< long enough to see drift, short enough not to tire her
  static constexpr double kStillMm = 3;  ///< more than tremor and the play of the handle
  static constexpr double kPushMm = 20;  ///< as in the self-test: a movement that no drift reaches

  void begin() { *this = {}; }
  /// All samples, oldest first. Returns whether the step changed.
  bool add(std::span<const haptics::Sample> samples);

  /// What to do now: kHold, kStill, kPush, kRelease or kReady.
  DeviceStep step() const { return step_; }

 private:
  void onSample(const haptics::Sample& sample);
  void rest(const haptics::Sample& sample);

  DeviceStep step_ = DeviceStep::kHold;
  bool seen_open_ = false;
  std::int64_t still_since_ns_ = 0;
  double at_mm_ = 0;  ///< where the hand began to be still, or the push began
};

// How long a device that asks to be held has waited for a hand.

class HoldClock {
 public:
  static constexpr double kHintS = 8;
  static constexpr double kStuckS = 20;

  /// What ends the wait: a hand that holds the device, or only `asks` itself.
  enum class WaitsFor { kHold, kPush };

  /// All samples, oldest first. `asks`: the device must be held, or pushed, now. Returns whether `wait` changed.
  bool add(std::span<const haptics::Sample> samples, bool asks, WaitsFor what = WaitsFor::kHold);
  void begin() { *this = {}; }
  HoldWait wait() const { return wait_; }

 private:
  std::optional<std::int64_t> since_ns_;
  HoldWait wait_ = HoldWait::kNot;
};

// One step of the force part: the pause, the force in the hand, and what is measured of it until the answer.

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
    kFelt,  ///< the full force was reached; an answer may be given once the hand has pushed against it
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
  /// The hand pushed against the full force as far as a judgement needs: an answer may be given, also after the force
  /// has ended. A force that ended without it comes once more.
  bool wasPushed() const { return phase_ == Phase::kFelt && pushed_; }
  /// It comes once more, because the hand did not push.
  bool isRepeated() const { return repeated_; }
  /// The pause lasts longer than the protocol asks, because the motors are warm.
  bool isWarm() const { return warm_; }

  /// What was measured so far, without the word. `wasPushed` must be true.
  experiments::ForceAnswer measured() const;

 private:
  void pause();
  double restS() const;
  void onSample(const haptics::Sample& sample);
  void order();
  void keepWay();

  DeviceSession& device_;
  experiments::ForcePlan plan_;
  Phase phase_ = Phase::kNone;
  std::uint64_t number_ = 0;  ///< of the stimulus; never used twice
  std::uint64_t orders_ = 0;  ///< samples with older orders are not of this stimulus
  bool warm_ = false;
  std::optional<std::int64_t> pause_since_ns_;
  std::int64_t full_ns_ = 0;
  bool pushed_ = false;
  bool repeated_ = false;
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

/// A rest every so many questions.
inline constexpr std::size_t kQuestionsToRest = 15;

/// What she has passed since she sat down. Nothing of it is stored: after a crash she passes it again.
struct CoursePassed {
  bool code = false;            ///< her code is known, and she left its screen
  bool device = false;          ///< the device was checked, and is still running
  bool glossary = false;        ///< the words were explained
  bool own_model = false;       ///< she felt her own model, or there is none
  std::set<std::string> rests;  ///< that she had: `restBefore` of each
  std::size_t blocks = 0;       ///< that were done when she sat down: no rest comes after those
  bool sealing = false;         ///< she locked her answers; the rating of the form is asked
  bool sealed = false;          ///< she saw that they are locked
  bool stopped = false;         ///< she stopped, or withdrew, or did not consent
  std::size_t replies = 0;      ///< to questions since the last rest
};

/// The "rest" that says that the practice of the forces is over.
inline constexpr const char* kBeginsToCount = "begins_to_count";

/// The rest that comes now, before what `at` asks; empty: none, or she had it. The same text for the same place.
std::string restBefore(const SessionSnapshot& at, const CoursePassed& passed);

/// A clinical teacher's session with the usability form.
bool isUsability(const SessionSnapshot& at);

/// `at`: null before the session has begun.
ParticipantScreen screenOf(const SessionSnapshot* at, const CoursePassed& passed);

}  // namespace tactus::workbench
