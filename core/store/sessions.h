// The sessions of a study file.
#pragma once

#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"

namespace tactus::store {

/// Adds a session at its start. Returns an error for an existing id or an unknown person.
base::Result<void> append(StudyFile& file, const study::SessionRecord& session);

/// All sessions, or those of `person`, by start time.
base::Result<std::vector<study::SessionRecord>> sessions(const StudyFile& file,
                                                         const std::optional<study::RecordId>& person = {});

/// A session with the numbers of its records, including corrected ones.
struct SessionSummary {
  study::SessionRecord session;
  std::string code;  ///< of the person
  bool simulated = false;
  long long strokes = 0;
  long long judgements = 0;
  long long answers = 0;
};

/// All sessions with their counts, for a list on the screen. Reads no recordings.
base::Result<std::vector<SessionSummary>> sessionList(const StudyFile& file);

}  // namespace tactus::store
