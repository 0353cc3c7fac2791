// Converts the history to versions of the model in a study file (core/store/model_versions.h), and back.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/editing/edit_history.h"
#include "core/study/session_records.h"

namespace tactus::editing {

// How the history of a model is continued when its file is opened again: from the versions kept so far and the model
// that the file has now.

/// A gesture that was in progress when it was kept.
struct Unfinished {
  std::string label;
  fuzzy::ForceModel model;
};

/// A gesture in progress is kept as a version of the kind `drag`, which is no entry of the history. It counts until a
/// later version follows: a drag that ended without an edit is followed by one with the model before it.
study::ModelVersion dragVersion(const EditHistory& history, study::RecordIds& ids, std::int64_t utc_ms);
bool isDrag(const study::ModelVersion& version);

/// Versions of a history file, as they were added, without drags.
struct KeptVersions {
  std::vector<study::ModelVersion> versions;
  std::optional<Unfinished> unfinished;  ///< the drag that was in progress at the end
};
/// Refused: a drag at the end whose text is no model. `versions`: with their texts.
base::Result<KeptVersions> withoutDrags(std::vector<study::ModelVersion> versions);

/// All of it: the drag in progress becomes one edit, `… (recovered)`, with the author and time of `stamp`. No event
/// counts as stored.
base::Result<EditHistory> wholeHistory(const KeptVersions& kept, study::RecordIds ids, const Stamp& stamp);

/// The entries among `versions`.
std::size_t editsIn(std::span<const study::ModelVersion> versions);

/// A continued history.
struct EarlierHistory {
  EditHistory history;             ///< its current state is the model of the file
  std::size_t kept = 0;            ///< the first events, which need not be written before another one follows
  std::optional<StateId> lost;     ///< the newest state, if the file has an older one
  std::optional<Unfinished> drag;  ///< the drag that was in progress on that state
  std::size_t edits = 0;           ///< entries after the state of the file, the drag included
  std::int64_t last_utc_ms = 0;    ///< of the last version
  bool changed_elsewhere = false;  ///< the file has a model that the history did not know; it is an edit of it now
};

/// Continues the history of `kept` with the model of the file, which the event `opened` of `fresh` has. Refused: no
/// versions, a text that is no model, and a model with other inputs than that of the file.
base::Result<EarlierHistory> goOn(KeptVersions kept, const EditHistory& fresh, study::RecordIds ids,
                                  const std::string& changed_label, const Stamp& stamp);

/// The version of one event. Its label gives the kind and the subject of the event (`edit: S4: …`, `sign-off: feels
/// right, after 12 edits`). Refused if the model is not in memory; it is then stored already.
base::Result<study::ModelVersion> versionOf(const EditHistory& history, const Event& event);

/// The same for a given model of the event's state, so that another thread can write its text.
study::ModelVersion versionOf(const Event& event, const fuzzy::ForceModel& model);

/// The versions that the study file lacks, parents first. Append them in this order and report each to
/// EditHistory::markStored.
std::vector<study::ModelVersion> unstoredVersions(const EditHistory& history);

/// The history of the versions of a study file, in the order in which they were added. The current state is the one of
/// the last version, which must have its text. Other versions may lack their texts; their states are read on demand
/// (EditHistory::missing, provideVersion). A version without a kind is an edit. The first `stored` versions are in the
/// study file; the others must have their texts, and their models stay in memory.
base::Result<EditHistory> historyFrom(std::span<const study::ModelVersion> versions, study::RecordIds ids,
                                      std::size_t stored = std::numeric_limits<std::size_t>::max());

/// Supplies the model of a state that is not in memory.
base::Result<void> provideVersion(EditHistory& history, StateId state, const study::ModelVersion& version);

}  // namespace tactus::editing
