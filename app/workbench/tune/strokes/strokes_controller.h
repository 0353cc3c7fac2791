// The recorded strokes of the open study, run through the model before and the present one after each edit: what would
// feel different. The model before is that of the curves (GhostController), or the one that was signed off last.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "app/editing/edit_history.h"
#include "app/replay/recorded_strokes.h"
#include "app/replay/stroke_replay.h"
#include "app/workbench/base/computed.h"
#include "app/workbench/model/open_model.h"

class QWidget;

namespace tactus::workbench {

class EditController;
class GhostController;
class SceneController;
class StudyConnection;

/// Thread: gui. Reads and computes in the background, and only while it is seen.
class StrokesController : public QObject {
  Q_OBJECT

 public:
  /// All outlive this.
  StrokesController(GhostController& ghost, EditController& edits, SceneController& scene, StudyConnection& study,
                    QObject* parent = nullptr);

  /// Nothing is read or computed while no view is seen.
  void setSeen(bool seen);

  enum class Against {
    kGhost,    ///< the model before of the curves
    kSignOff,  ///< the state that was signed off last
  };
  /// kGhost where nothing is signed off.
  Against against() const { return signed_off_ ? against_ : Against::kGhost; }
  bool isSignedOff() const { return signed_off_.has_value(); }

  enum class State {
    kNoModel,
    kNoStudy,
    kNoStroke,    ///< the study has none
    kGhostOff,    ///< the user switched the model before off
    kWaiting,     ///< for the first result
    kUnreadable,  ///< the study could not be read: `failure`
    kNothing,     ///< no stroke can be compared: `leftOut` says why
    kShown,
  };
  State state() const;
  /// The result belongs to an older model.
  bool isOld() const;
  /// A study is open that takes records, or none is.
  bool mayRecord() const;
  /// One sentence.
  QString failure() const { return failure_; }

  /// The comparison on the screen; needs kShown. Both belong together.
  const replay::StrokeBaseline& baseline() const { return *shown_->baseline; }
  const replay::StrokeComparison& comparison() const { return shown_->comparison; }
  const replay::RecordedStroke& stroke(std::size_t place) const;

  /// The one line: how many strokes would feel different, and where most.
  QString headline() const;
  /// What is compared, and what the numbers do not say.
  QString caption() const;
  /// One sentence for each reason why strokes are left out.
  QStringList leftOut() const;
  /// `recording 1, stroke 4`.
  QString nameOf(std::size_t place) const;
  /// `+3.0 JND`, or where the stroke meets a hole.
  QString verdictOf(std::size_t place) const;
  /// All numbers of a stroke, a line each.
  QString numbersOf(std::size_t place) const;

  /// Place in the comparison.
  std::optional<std::size_t> chosen() const;
  /// The recording of the chosen stroke, which can be replayed; nothing for a stroke of the speed experiment.
  std::optional<study::RecordId> chosenRecording() const;

 public slots:
  /// Moves the operating point to the largest difference of a stroke, with its conditions.
  void goTo(std::size_t place);
  void choose(std::size_t place);
  void setAgainst(tactus::workbench::StrokesController::Against against);
  /// Compares with the model before again.
  void showGhost();
  /// Asks for the replay of the recording of the chosen stroke, if it has one.
  void replayChosen();

 signals:
  void changed();
  void chosenChanged();
  /// Strokes are wanted: to record some while the model is felt.
  void recordRequested();
  void replayRequested(const tactus::study::RecordId& recording);

 private:
  using Strokes = std::shared_ptr<const std::vector<replay::RecordedStroke>>;
  struct BaselineInputs {
    Strokes strokes;
    editing::SharedModel before;
    replay::Conditions conditions;
  };
  struct ComparedInputs {
    std::shared_ptr<const replay::StrokeBaseline> baseline;
    editing::SharedModel after;
    QString label;
  };
  struct Shown {
    std::shared_ptr<const replay::StrokeBaseline> baseline;
    replay::StrokeComparison comparison;
  };

  /// The state that was signed off last.
  struct SignedOff {
    study::RecordId event;
    QString label;
    editing::SharedModel model;
  };

  void read();
  void onStudy();
  void findSignOff();
  QString label() const;
  void onRead(std::shared_ptr<const replay::StoredStrokes> stored, const QString& failure);
  void onModels();
  void onValue(std::size_t input);
  void onCompared();
  replay::Conditions conditions() const;
  editing::SharedModel before() const;
  bool wantsConditions() const;

  GhostController& ghost_;
  EditController& edits_;
  SceneController& scene_;
  StudyConnection& study_;
  Against against_ = Against::kGhost;
  std::optional<SignedOff> signed_off_;
  bool seen_ = false;
  bool unread_ = true;       ///< the study may have other strokes
  std::size_t reading_ = 0;  ///< number of the newest reading
  std::shared_ptr<const replay::StoredStrokes> stored_;
  QString failure_;
  editing::SharedModel wanted_before_;  ///< that `baseline_` has or computes; null: none
  std::shared_ptr<const Shown> shown_;
  QString label_;                      ///< of the model before that is shown
  std::optional<std::size_t> chosen_;  ///< index of the stroke, whatever its place
  Computed<std::shared_ptr<const replay::StoredStrokes>, std::vector<replay::RecordedStroke>> strokes_;
  Computed<BaselineInputs, replay::StrokeBaseline> baseline_;
  Computed<ComparedInputs, Shown> compared_;
};

/// The strip of traces. It holds what it shows only while it is visible.
QWidget* makeStrokesPanel(StrokesController& strokes);

}  // namespace tactus::workbench
