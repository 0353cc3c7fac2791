// The order of a participant's sessions, independent of the clocks of the stations.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"

namespace tactus::session {

/// The detail of a session's first event: the participant's latest session in the file when this one began. Exports and
/// merges keep it.
std::string afterDetail(const std::optional<study::RecordId>& latest);

/// The sessions of `person`, earliest first. A session comes after the one that its log names. Sessions without such a
/// relation, for example of two stations, are ordered by their start time, then by id. So a clock that was set back
/// does not change the order within a file, and the order of merges never does.
base::Result<std::vector<study::SessionRecord>> sessionsInOrder(const store::StudyFile& file,
                                                                const study::RecordId& person);

/// The last of them; nothing if there is none.
base::Result<std::optional<study::RecordId>> latestSession(const store::StudyFile& file, const study::RecordId& person);

}  // namespace tactus::session
