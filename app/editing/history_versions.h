// Converts the history to versions of the model in a study file (core/store/model_versions.h), and back.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "app/editing/edit_history.h"
#include "core/study/session_records.h"

namespace tactus::editing {

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
