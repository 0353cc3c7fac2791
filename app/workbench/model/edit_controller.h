// Edits of the open model with undo: gestures that are shown while they go on, one entry in the history for each, and
// what each did to the force. Every part of the program that changes the model does it here.
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
  /// Follows `models`: a model that is opened begins a history of its own.
  explicit EditController(ModelController& models, QObject* parent = nullptr);

  /// Whether a model is open. Everything below may be called with a model only.
  bool isOpen() const { return history_.has_value(); }
  /// The model as it stands, a gesture that goes on included.
  const fuzzy::ForceModel& model() const { return history_->model(); }
  /// The model at the beginning of the gesture, from which its edits start.
  const fuzzy::ForceModel& base() const { return history_->base(); }
  bool inGesture() const { return history_ && history_->inGesture(); }
  /// Why the gesture went less far than asked; empty where it did not stop.
  const QString& stopped() const { return stopped_; }

  /// Everything that happened to the model since it was opened: what a study file and a recovery store.
  const editing::EditHistory& history() const { return *history_; }
  /// The event is in a study file now.
  void markStored(const study::RecordId& id);
  /// Reads a version of the model from where it was stored.
  using VersionReader = std::function<base::Result<study::ModelVersion>(const study::RecordId&)>;
  /// Goes on with `history`, read from a study or after a crash, in the place of the present one, which is dropped. The
  /// open model becomes its current one, over the same inputs. States that are not in memory come from `read`; without
  /// one nobody can return to them.
  void adopt(editing::EditHistory history, VersionReader read = {});
  /// The model of any state, read where it is not in memory.
  base::Result<editing::SharedModel> readyOf(editing::StateId state);
  /// Who edits, from now on; empty where nobody said.
  void setAuthor(const QString& name);
  const QString& author() const { return author_; }
  /// Who edits, `unnamed` where nobody said, and now.
  editing::Stamp stamp() const;

  /// A gesture: begun, updated any number of times, committed or cancelled. Its models go to the ModelController at
  /// most once in 16 ms, the latest one wins; the last one always arrives.
  void begin();
  /// Shows the edit, made from `base()`. An error is announced and leaves the gesture as it was. Returns whether it was
  /// none.
  bool update(base::Result<editing::Edit> edit);
  void commit();
  void cancel();
  /// An edit of `model()` that is a gesture by itself.
  bool apply(base::Result<editing::Edit> edit);
  /// Says that something could not be done, in one sentence.
  void refuse(const QString& sentence);

  bool canUndo() const { return history_ && (history_->canUndo() || inGesture()); }
  bool canRedo() const { return history_ && history_->canRedo(); }
  /// What undo takes back, and what redo brings again; empty where there is nothing.
  QString undoText() const;
  QString redoText() const;

  /// What the edit that made `state` did to the force, computed when first asked for: `max ΔF 0.032 N (0.4 JND)`. Empty
  /// for the model that was opened, and until a state that is not in memory has been read.
  QString effectOf(editing::StateId state);

  /// The same in numbers; nothing where it is not known.
  std::optional<editing::EditImpact> impactOf(editing::StateId state);
  /// The curve on the screen showed this of the edit that made the current state: no number of it is smaller from now
  /// on.
  void include(const editing::GhostCurve& curve, std::size_t input, std::span<const double> point);

  /// Names the current state. Without a name nothing happens.
  void snapshot(const QString& name);
  /// `who`, an expert's name or code, says of the current state: this feels right.
  void signOff(const QString& who);

 public slots:
  void undo();
  void redo();
  /// Back or forward to any state of the list.
  void returnTo(tactus::editing::StateId state);

 signals:
  /// Another model was opened; the history is empty.
  void modelReset();
  /// An edit that was accepted is about to be made and sent; `changed` follows where it changed something.
  void sending();
  /// `model()` changed.
  void changed();
  /// Undo, redo or the list of entries changed: there may be new events to store.
  void historyChanged();
  /// An event was marked as stored.
  void stored();
  /// What an edit did is about to be said: the curve on the screen has to be looked at.
  void reporting();
  /// What the edits did is known better.
  void effectsChanged();
  /// After an edit: what changed and what it does to the force.
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
  QString stopped_;
  QTimer frame_;      ///< runs for 16 ms after a model was sent
  bool due_ = false;  ///< a newer one waits for its end
  QTimer report_;
};

}  // namespace tactus::workbench
