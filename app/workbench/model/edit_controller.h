// Edits of the open model, with undo. A gesture (for example a drag) is shown while it is in progress and becomes one
// entry of the history, with its effect on the force. Every part of the program changes the model through this class.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "app/editing/edit_history.h"
#include "app/editing/history_versions.h"
#include "app/workbench/model/model_controller.h"

namespace tactus::workbench {

class EditController : public QObject {
  Q_OBJECT

 public:
  /// Follows `models`: each model that is opened starts its own history.
  explicit EditController(ModelController& models, QObject* parent = nullptr);

  /// Whether a model is open. All other functions need an open model.
  bool isOpen() const { return history_.has_value(); }
  /// The current model, including a gesture in progress.
  const fuzzy::ForceModel& model() const { return history_->model(); }
  /// The model at the beginning of the gesture. Edits of the gesture start from it.
  const fuzzy::ForceModel& base() const { return history_->base(); }
  bool inGesture() const { return history_ && history_->inGesture(); }
  /// Why the gesture stopped short of the request; empty if it did not stop.
  const QString& stopped() const { return stopped_; }

  /// All events of the model since it was opened. The study file and the autosave store them.
  const editing::EditHistory& history() const { return *history_; }
  /// Marks the event as stored in a study file.
  void markStored(const study::RecordId& id);
  /// Reads a version of the model from its storage.
  using VersionReader = std::function<base::Result<study::ModelVersion>(const study::RecordId&)>;
  /// Replaces the current history by `history`, read from a study or after a crash. The current state of `history`
  /// becomes the open model; it must have the same inputs. `read` supplies states that are not in memory; without it
  /// the user cannot return to them.
  void adopt(editing::EditHistory history, VersionReader read = {});
  /// The model of any state, read where it is not in memory.
  base::Result<editing::SharedModel> readyOf(editing::StateId state);
  /// The author of edits from now on; empty if unknown.
  void setAuthor(const QString& name);
  const QString& author() const { return author_; }
  /// The author (`unnamed` if not known) and the current time.
  editing::Stamp stamp() const;

  /// A gesture: begin it, update it any number of times, then commit or cancel it. The ModelController gets the newest
  /// model at most once per 16 ms, and always gets the last one.
  void begin();
  /// Shows the edit, made from `base()`. An error is announced and leaves the gesture unchanged. Returns false for an
  /// error.
  bool update(base::Result<editing::Edit> edit);
  void commit();
  void cancel();
  /// Makes an edit of `model()` as a gesture of its own.
  bool apply(base::Result<editing::Edit> edit);
  /// Announces in one sentence that an action is refused.
  void refuse(const QString& sentence);

  bool canUndo() const { return history_ && (history_->canUndo() || inGesture()); }
  bool canRedo() const { return history_ && history_->canRedo(); }
  /// The edits that undo takes back and redo brings back; empty if there is none.
  QString undoText() const;
  QString redoText() const;

  /// What the edit that made `state` did to the force, computed when first asked for: `max ΔF 0.032 N (0.4 JND)`. Empty
  /// for the model that was opened, and until a state that is not in memory has been read.
  QString effectOf(editing::StateId state);

  /// The same as numbers; nothing if it is not known.
  std::optional<editing::EditImpact> impactOf(editing::StateId state);
  /// Reports what the curve on the screen shows about the edit that made the current state. From then on no number of
  /// that edit's effect is smaller than on the curve.
  void include(const editing::GhostCurve& curve, std::size_t input, std::span<const double> point);

  /// Names the current state. Does nothing if `name` is empty.
  void snapshot(const QString& name);
  /// Records that `who`, an expert's name or code, approves the current state, with how it was felt (`setFelt`).
  /// `felt`: how it was felt otherwise, in the place of that.
  void signOff(const QString& who, const std::optional<editing::Felt>& felt = std::nullopt);
  /// Repeats a sign-off that was recorded elsewhere, with its label.
  void repeatSignOff(const QString& who, const std::string& label);
  /// How the current state was felt so far; no strokes until it is felt.
  void setFelt(editing::Felt felt);
  const editing::Felt& felt() const { return felt_; }

 public slots:
  void undo();
  void redo();
  /// Returns to any state of the list.
  void returnTo(tactus::editing::StateId state);

 signals:
  /// Another model was opened; the history is new.
  void modelReset();
  /// An accepted edit is about to be made and sent. `changed` follows if it changes the model.
  void sending();
  /// `model()` changed.
  void changed();
  /// Undo, redo or the list of entries changed. There may be new events to store.
  void historyChanged();
  /// An event was marked as stored.
  void stored();
  /// The current state was felt, or another state is current.
  void feltChanged();
  /// The effect of an edit is about to be reported. Receivers must now call `include` for the curve on the screen.
  void reporting();
  /// The effects of edits became known or more exact.
  void effectsChanged();
  /// Comes after an edit: what changed, and the effect on the force.
  void reported(const QString& sentence);
  void refused(const QString& sentence);

 private:
  void adoptModel();
  void begin(editing::EditHistory history, VersionReader read);
  base::Result<void> fetch(std::optional<editing::StateId> state);
  void schedule();
  void send();
  void settle(const base::Result<void>& moved, const QString& sentence);
  void report();

  ModelController& models_;
  std::optional<editing::EditHistory> history_;
  VersionReader read_version_;
  QString author_;
  editing::Felt felt_;
  QString stopped_;
  QTimer frame_{this};  ///< runs for 16 ms after a model was sent
  bool due_ = false;    ///< a newer model waits for the end of `frame_`
  QTimer report_{this};
};

}  // namespace tactus::workbench
