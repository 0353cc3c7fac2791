// A blind duel of two models on a device: gives the hand one stroke after the other, asks, and keeps every answer in
// the open study. It is a run of its own on the device, so nothing on the bench shows what the hand feels.
#pragma once

#include <QObject>
#include <QString>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/editing/edit_history.h"
#include "app/workbench/device/device_session.h"
#include "app/workbench/feel/recordings/feel_store.h"
#include "app/workbench/model/open_model.h"
#include "core/base/error.h"
#include "core/haptics/servo/sample.h"
#include "core/haptics/sources/servo_scene.h"
#include "core/store/duel_records.h"
#include "core/study/session_records.h"
#include "elicitation/force/noticeable_force.h"
#include "experiments/duel_run.h"

namespace tactus::workbench {

class StudyConnection;

/// What is compared, and where.
struct DuelSetup {
  std::shared_ptr<const OpenModel> a;  ///< both over the same inputs
  std::shared_ptr<const OpenModel> b;
  study::DuelModel a_name;  ///< as the study keeps them
  study::DuelModel b_name;
  std::optional<bool> open_is_b;             ///< which of them is the open model as it is now; nothing: neither
  std::map<std::string, double> conditions;  ///< of all inputs but depth and speed
  double from_mm = 0;
  double to_mm = 0;
  double speed_mm_s = 0;
  study::DuelQuestion question = study::DuelQuestion::kHeavier;
  study::DuelRule rule = study::DuelRule::kFixed;
};

/// What is known before the first stroke.
struct DuelForecast {
  elicitation::StrokeDifference difference;
  std::optional<experiments::BinomialTest> test;  ///< nothing: no number of trials would find it
};
/// `setup` needs a and b with the inputs depth and speed. Nothing where no force is found along the stroke.
std::optional<DuelForecast> duelForecast(const DuelSetup& setup);

/// `model` with every force multiplied by `factor` > 0.
fuzzy::ForceModel withScaledForce(fuzzy::ForceModel model, double factor);

/// Thread: gui.
class DuelController : public QObject {
  Q_OBJECT

 public:
  enum class State {
    kIdle,      ///< no duel
    kStarting,  ///< the device starts
    kLetGo,     ///< the hand has to let go, and go back
    kPush,      ///< the hand takes the tube and pushes
    kQuestion,
    kRest,         ///< a rest is offered
    kInterrupted,  ///< the device has stopped or tripped; it can go on
    kDone,
  };

  DuelController(DeviceSession& device, StudyConnection& study, const FeelStore& felt, QObject* parent = nullptr);
  /// Ends a run in progress.
  ~DuelController() override;

  State state() const { return state_; }
  /// The duel in progress or the last one; null before the first.
  const experiments::DuelRun* run() const { return run_ ? &*run_ : nullptr; }
  /// Depth of the tip during a stroke; nothing while no force is given.
  std::optional<double> depthMm() const;
  /// Where it should be at the prompted speed; nothing before the way begins.
  std::optional<double> promptMm() const;
  /// The last stroke was made while the limits held the force back (it fades in at first, or the motors rest). It is
  /// made again and is in no record.
  bool wasHeldBack() const { return held_back_; }
  /// Of a finished one.
  experiments::DuelVerdict verdict() const { return experiments::verdictOf(run_->start(), run_->answers()); }
  /// Whether the study has everything so far.
  bool isKept() const { return kept_; }
  /// How the open model was felt in this duel; nothing if it is none of the two, or the device gives no force.
  std::optional<editing::Felt> feltOpenModel() const;

  /// Starts a duel on the device `id`. `seed`: of all its orders. Refused: a setup without a difference, a model that
  /// the servo refuses, a device in use.
  base::Result<void> begin(const DuelSetup& setup, const QString& id, std::uint64_t seed);
  /// Goes on with a duel that was interrupted, of the same two models.
  base::Result<void> resume(const DuelSetup& setup, const store::StoredDuel& stored, const QString& id);

 public slots:
  void answer(tactus::study::DuelChoice choice);
  /// After a rest, or an interruption.
  void goOn();
  /// Ends it: no force, and what was answered stays.
  void stop();

 signals:
  void changed();
  /// The hand moved. At most 60 times a second.
  void moved();
  /// One sentence: what was not started or not kept, and why.
  void failed(const QString& sentence);

 private:
  base::Result<void> prepare(const DuelSetup& setup);
  base::Result<std::shared_ptr<const haptics::ServoScene>> sceneOf(const experiments::DuelForce& force) const;
  void start(const QString& id);
  void onState();
  void look(std::span<const haptics::Sample> samples);
  void onSample(const haptics::Sample& sample);
  void giveStroke();
  void endStroke(double reached_mm, std::int64_t time_ns);
  void takeNext();
  void free();
  void enter(State state);
  study::Entry entry();
  template <class Record>
  void keep(Record record);

  DeviceSession& device_;
  StudyConnection& study_;
  const FeelStore& felt_;
  std::shared_ptr<FeelSessions> sessions_ = std::make_shared<FeelSessions>();  ///< used by the study's thread alone
  study::RecordIds ids_;
  FeelSessions::Visit visit_;
  State state_ = State::kIdle;
  DuelSetup setup_;
  QString device_id_;
  std::shared_ptr<const haptics::ServoScene> scene_a_;
  std::shared_ptr<const haptics::ServoScene> scene_b_;
  double per_jnd_ = 0;  ///< share by which the force of A grows for one JND along the stroke
  std::optional<experiments::DuelRun> run_;
  bool resumed_ = false;  ///< its plan is in the study already
  bool kept_ = false;
  unsigned strokes_[2] = {0, 0};  ///< whole ones on A and on B

  /// The current stroke.
  std::uint64_t orders_ = 0;  ///< with which it was given
  double offset_mm_ = 0;      ///< from a sample's depth to that of the model
  std::optional<double> began_mm_;
  std::optional<std::int64_t> began_ns_;  ///< passed the beginning of the way
  std::optional<std::int64_t> ended_ns_;  ///< of the stroke before
  std::int64_t asked_ns_ = 0;
  bool held_back_ = false;
};

}  // namespace tactus::workbench
