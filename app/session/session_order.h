// In which order the sessions of a participant were, whatever the clocks of the stations said.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"

namespace tactus::session {

/// The detail of the first event of a session: the session of the same participant that the file had as the latest
/// when this one began. It goes along with exports and merges.
std::string afterDetail(const std::optional<study::RecordId>& latest);

/// The sessions of `person`, earliest first. A session comes after the one that its log names; sessions that no log
/// relates, such as those of two stations, stand by the time of their beginning, then by id. So a clock that was set
/// back changes nothing within a file, and the order of merges never does.
base::Result<std::vector<study::SessionRecord>> sessionsInOrder(const store::StudyFile& file,
                                                                const study::RecordId& person);

/// The last of them, or nothing.
base::Result<std::optional<study::RecordId>> latestSession(const store::StudyFile& file, const study::RecordId& person);

}  // namespace tactus::session
