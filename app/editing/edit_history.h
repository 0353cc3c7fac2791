// Undo, redo, snapshots and sign-off of one model: a tree of states in which nothing is ever overwritten.
// A state is the model after one gesture. An edit after an undo begins a branch:
//   open (0) -> edit (1) -> edit (2); undo to 1; edit (3)
//   state 1 now has two children: 2 (a branch) and 3 (the current line)
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "app/editing/edit.h"
#include "app/editing/edit_impact.h"
#include "core/fuzzy/force_model.h"
#include "core/study/record_id.h"

namespace tactus::editing {

/// A model in the history. Experts that an edit did not change share their memory with the previous state.
class KeptModel {
 public:
  /// Keeps `model`. An expert that is bit for bit the same in `like`, at the same index, is shared. `like` may be null.
  KeptModel(const fuzzy::ForceModel& model, const KeptModel* like);

  /// The model, bit for bit.
  fuzzy::ForceModel restored() const;

  /// The approximate bytes of the model without the experts in `counted`; adds its experts to `counted`.
  std::size_t bytes(std::unordered_set<const fuzzy::Expert*>& counted) const;

 private:
  fuzzy::ForceModel rest_;  ///< the model without experts
  std::vector<std::shared_ptr<const fuzzy::Expert>> experts_;
};

// What a sign-off says. "Feels right" needs a stroke of the hand on that very state; without one it is an approval.

/// How one state of the model was felt.
struct Felt {
  unsigned strokes = 0;              ///< that began on this state
  std::string device;                ///< its name; that of the last stroke
  bool simulated = false;            ///< a program moved, or there was no hardware
  std::vector<std::string> regions;  ///< labels of the regions that the tip reached, in the order of the depth

  bool operator==(const Felt&) const = default;
};

/// `feels right, after 3 edits: 4 strokes on Touch, Nasal cavity to Oropharynx`; the device with `(simulated)` behind
/// it where it is one. `approved without feeling, after 3 edits` for no stroke.
std::string signOffText(std::size_t edits, const Felt& felt);

/// Whether the label of a sign-off says that the state was felt. Labels stay as they are stored.
bool saysFelt(const std::string& label);

/// The number of a state of the model, from 0 in the order of creation.
using StateId = std::size_t;

/// The author and the time of an event.
struct Stamp {
  std::string author;
  std::int64_t utc_ms = 0;

  bool operator==(const Stamp&) const = default;
};

enum class EventKind {
  kOpened,    ///< the first model of the history
  kEdit,      ///< a new state
  kUndo,      ///< back to the state before
  kRedo,      ///< forward again
  kReturn,    ///< to any other state
  kSnapshot,  ///< a state was named
  kSignOff,   ///< an expert approved a state, felt or not
};

/// `opened`, `edit`, `undo`, `redo`, `return`, `snapshot`, `sign-off`.
std::string_view name(EventKind kind) noexcept;

/// One event; each becomes a version of the model in the study file (history_versions.h).
struct Event {
  study::RecordId id;
  std::optional<study::RecordId> parent;  ///< the version from which the state was made, or which has the same text
  EventKind kind = EventKind::kEdit;
  std::string label;
  Stamp stamp;
  StateId state = 0;    ///< of the model after the event
  bool stored = false;  ///< in the study file
};

/// One state of the model.
struct State {
  std::optional<StateId> parent;                       ///< the state that was edited
  std::optional<StateId> redo;                         ///< where redo goes from here
  std::size_t event = 0;                               ///< index of the event that made it
  std::size_t edits = 0;                               ///< gestures from the model that was opened to this state
  std::shared_ptr<const KeptModel> kept;               ///< null where it has to be read from the study file
  std::optional<EditImpact> impact;                    ///< of the edit that made it, once it was asked for
  mutable std::weak_ptr<const ReadyModel> ready = {};  ///< while the history or its user holds it
};

/// Thread: one at a time.
class EditHistory {
 public:
  /// Starts with `model`, which must be valid. `ids` names the versions.
  static base::Result<EditHistory> open(const fuzzy::ForceModel& model, const std::string& label, const Stamp& stamp,
                                        study::RecordIds ids);
  /// The same for a model that is compiled already.
  static EditHistory open(SharedModel model, const std::string& label, const Stamp& stamp, study::RecordIds ids);

  /// The model to feel and to show: that of the current state, or of the gesture in progress.
  const SharedModel& ready() const { return shown_ ? shown_->ready : ready_; }
  const fuzzy::ForceModel& model() const { return ready()->model; }
  const fuzzy::CompiledModel& compiled() const { return ready()->compiled; }

  /// Begins a gesture (a drag, a series of arrow keys). Every update is an edit of `base`, and the whole gesture
  /// becomes one entry. All functions that change or name the state end it with `commit`.
  void begin();
  bool inGesture() const { return in_gesture_; }
  /// The change of the gesture so far, in words; empty if there is none.
  std::string gestureLabel() const { return shown_ ? shown_->label : std::string(); }
  /// The model at the beginning of the gesture: what its edits start from.
  const fuzzy::ForceModel& base() const { return ready_->model; }
  /// Shows `edit`; begins a gesture if none is in progress.
  void update(Edit edit);
  /// Makes the last update an entry. Returns nothing if there was no update or no change.
  std::optional<StateId> commit(const Stamp& stamp);
  /// Drops the gesture.
  void cancel();
  /// Makes an edit as a gesture of its own. Returns nothing if it changed nothing.
  std::optional<StateId> apply(Edit edit, const Stamp& stamp);

  bool canUndo() const { return states_[current_].parent.has_value(); }
  bool canRedo() const { return states_[current_].redo.has_value(); }
  /// Refused: nothing to undo; a state whose model is not in memory (`missing`). An edit after an undo begins a branch;
  /// the old branch stays and the user can return to it.
  base::Result<void> undo(const Stamp& stamp);
  base::Result<void> redo(const Stamp& stamp);
  /// Returns to any state.
  base::Result<void> returnTo(StateId state, const Stamp& stamp);

  /// Names the current state.
  void snapshot(const std::string& name, const Stamp& stamp);
  /// The author of `stamp` signs off the current state. The event's label says after how many edits and how it was felt
  /// (edit_history.h).
  void signOff(const Stamp& stamp, const Felt& felt = {});
  /// A sign-off that was recorded elsewhere, with its label.
  void repeatSignOff(const Stamp& stamp, const std::string& label);

  StateId current() const { return current_; }
  const std::vector<State>& states() const { return states_; }
  const std::vector<Event>& events() const { return events_; }
  const std::string& labelOf(StateId state) const { return events_[states_[state].event].label; }
  /// The name that the user gave the state last, or its label.
  const std::string& nameOf(StateId state) const;
  /// The version of the event that made the state.
  const study::RecordId& versionOf(StateId state) const { return events_[states_[state].event].id; }
  /// The undo list: from the opened model through the current state to the end of redo.
  std::vector<StateId> line() const;

  /// The model of a state, for comparisons. Refused if it is not in memory.
  base::Result<fuzzy::ForceModel> modelOf(StateId state) const;
  /// The same with its compiled form. Compiles only what neither the history nor its user holds: the current state and
  /// the one before it are held.
  base::Result<SharedModel> readyOf(StateId state) const;
  /// How much the edit that made `state` changed the force, computed when first asked for (editImpact says how long
  /// that takes). Nothing for a model that was opened, or where a model is not in memory.
  std::optional<EditImpact> impact(StateId state);
  /// Raises the impact of `state` to the change that a curve on the screen shows (edit_impact.h). Returns whether it
  /// grew; false if there is no impact.
  bool include(StateId state, const GhostCurve& curve, std::size_t input, std::span<const double> point);
  /// The difference between any two states.
  base::Result<EditImpact> compare(StateId before, StateId after) const;

  /// Marks the event as stored in the study file.
  void markStored(const study::RecordId& id);
  /// Drops the models of the oldest states until about `most_bytes` are left. Keeps models of unstored versions, of the
  /// current state, of snapshots and of signed-off states. Returns the bytes left.
  std::size_t trim(std::size_t most_bytes);
  /// The version to read for a state whose model is not in memory; nothing if it is in memory.
  std::optional<study::RecordId> missing(StateId state) const;
  /// Supplies that model, read from the version `version`. Refused if the state has another version.
  base::Result<void> provide(StateId state, const study::RecordId& version, const fuzzy::ForceModel& model);

 private:
  friend class HistoryReader;

  explicit EditHistory(study::RecordIds ids) : ids_(ids) {}
  void record(EventKind kind, std::string label, const Stamp& stamp, std::optional<study::RecordId> parent);
  base::Result<void> moveTo(StateId state, EventKind kind, const Stamp& stamp);
  void enter(StateId state, SharedModel model);

  study::RecordIds ids_;
  std::vector<State> states_;
  std::vector<Event> events_;
  StateId current_ = 0;
  SharedModel ready_;   ///< of the current state
  SharedModel before_;  ///< of the state that was current before; null at the beginning
  bool in_gesture_ = false;
  /// The last update of a gesture.
  struct Shown {
    SharedModel ready;
    std::string label;
  };
  std::optional<Shown> shown_;
};

// Where the edits of a version begin, to carry them over to another one (rebase.h).

/// Gives the model of a state, read where it is not in memory.
using StateReader = std::function<base::Result<SharedModel>(StateId)>;

/// The oldest ancestor of `state` of the same build: the model as it was built. Builds are told apart by the time,
/// program and origin that the model names, which no edit changes.
base::Result<StateId> firstOfBuild(const EditHistory& history, StateId state, const StateReader& read);

/// The state with which the edits of `tuned` begin that `target` lacks: for a target of another build, firstOfBuild;
/// else where the ways to the two states part. `tuned` itself: there are no edits.
base::Result<StateId> beginningOf(const EditHistory& history, StateId tuned, StateId target, const StateReader& read);

// The history as rows from top to bottom: the line of undo and redo, and the branches beside it.

/// One state of the model.
struct HistoryRow {
  enum class Place {
    kDone,  ///< on the way to the current state
    kCurrent,
    kUndone,  ///< redo leads to it
    kBranch,  ///< left by an edit after an undo; the user can return to it
  };
  StateId state = 0;
  Place place = Place::kDone;
  std::size_t level = 0;           ///< depth of the indent: a branch is one level deeper than its parent state
  bool starts = false;             ///< first row of its level in this run
  bool goes_on = false;            ///< more rows of its level follow
  std::vector<std::size_t> marks;  ///< indices of the events that named or signed it, oldest first
};

/// Every state once. A branch stands between its parent state and the next state of the line.
std::vector<HistoryRow> historyRows(const EditHistory& history);

}  // namespace tactus::editing
