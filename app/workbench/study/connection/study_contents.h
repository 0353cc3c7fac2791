// The part of a study that every screen may need as soon as it is open: participants, recordings, and what happened to
// the file.
#pragma once

#include <QString>
#include <cstdint>
#include <vector>

#include "app/workbench/base/messages.h"
#include "core/store/feel_records.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"

namespace tactus::workbench {

/// A person who can feel a model.
struct StudyPerson {
  study::RecordId id;
  QString code;
  bool simulated = false;
  bool researcher = false;  ///< says so in a profile
};

/// The profile category that marks the researcher of a study.
inline constexpr auto kResearcherCategory = "researcher";

struct StudyContents {
  QString path;
  std::vector<StudyPerson> people;  ///< sorted by code
  std::vector<store::FeelSummary> recordings;
  StudyNotices notices;
};

/// Reads the study. Thread: the one of `file`.
base::Result<StudyContents> readContents(const store::StudyFile& file);

/// What happened to the study. Thread: that of `file`.
base::Result<StudyNotices> readNotices(const store::StudyFile& file);

/// The participants of the study. Thread: that of `file`.
base::Result<std::vector<StudyPerson>> readPeople(const store::StudyFile& file);

/// The current time of the wall clock, ms since 1970 UTC.
std::int64_t utcNowMs();

}  // namespace tactus::workbench
