// The history as versions of the model in a study file (core/store/model_versions.h), and back.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "app/editing/edit_history.h"
#include "core/study/session_records.h"

namespace tactus::editing {

/// The version of one event: its label says the kind of the event and what it was about (`edit: S4: …`,
/// `sign-off: feels right, after 12 edits`). Refused where the model is not in memory; then it is stored already.
base::Result<study::ModelVersion> versionOf(const EditHistory& history, const Event& event);

/// The same where the model of the event's state is at hand, so that another thread can write it as text.
study::ModelVersion versionOf(const Event& event, const fuzzy::ForceModel& model);

/// What the study file does not have yet, parents first: to be appended in this order, each then told to
/// EditHistory::markStored.
std::vector<study::ModelVersion> unstoredVersions(const EditHistory& history);

/// The history that the versions of a study file tell, in the order in which they were added; its current state is the
/// one of the last version, which must have its text. The others may come without: their states are then read when
/// somebody returns to them (EditHistory::missing, provideVersion). A version that does not say its kind is an edit.
/// The first `stored` of them are in the study file; the others must have their texts, whose models are kept.
base::Result<EditHistory> historyFrom(std::span<const study::ModelVersion> versions, study::RecordIds ids,
                                      std::size_t stored = std::numeric_limits<std::size_t>::max());

/// Gives the history the model of a state that it does not have in memory.
base::Result<void> provideVersion(EditHistory& history, StateId state, const study::ModelVersion& version);

}  // namespace tactus::editing
