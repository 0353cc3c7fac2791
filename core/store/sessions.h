// The sessions of a study file.
#pragma once

#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"

namespace tactus::store {

/// Begins a session. Refused: an id that is there already, an unknown person.
base::Result<void> append(StudyFile& file, const study::SessionRecord& session);

/// All sessions, or those of `person`, in the order in which they began.
base::Result<std::vector<study::SessionRecord>> sessions(const StudyFile& file,
                                                         const std::optional<study::RecordId>& person = {});

/// A session and how much of it is there; corrected records are counted too.
struct SessionSummary {
  study::SessionRecord session;
  std::string code;  ///< of the person
  bool simulated = false;
  long long strokes = 0;
  long long judgements = 0;
  long long answers = 0;
};

/// All sessions with their counts, for a list on the screen. No recording is read.
base::Result<std::vector<SessionSummary>> sessionList(const StudyFile& file);

}  // namespace tactus::store
