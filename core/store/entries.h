// The records of sessions: what participants did and said. They are added and read, never changed.
#pragma once

#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"

namespace tactus::store {

/// Adds a record to its session, in a transaction of its own: on success it is committed and synced. Refused, with
/// nothing written: an id that is there already, an unknown session, a number that is not finite or outside its range,
/// a correction of a record that was corrected before or that belongs to another person.
base::Result<void> append(StudyFile& file, const study::ProfileRecord& record);
base::Result<void> append(StudyFile& file, const study::EventRecord& record);
base::Result<void> append(StudyFile& file, const study::StrokeRecord& record);
base::Result<void> append(StudyFile& file, const study::JudgementRecord& record);
base::Result<void> append(StudyFile& file, const study::AnswerRecord& record);
base::Result<void> append(StudyFile& file, const study::RatingRecord& record);
base::Result<void> append(StudyFile& file, const study::RuleRecord& record);

/// Which records to read; each condition that is given must hold.
struct Selection {
  std::optional<study::RecordId> person = {};
  std::optional<study::RecordId> session = {};
  /// Also the records that were corrected.
  bool history = false;
};

enum class Recordings {
  kRead,
  kLeaveOut,  ///< strokes come without samples: fast for lists
};

/// The selected records, session after session as they began, within a session as they were added.
base::Result<std::vector<study::ProfileRecord>> profiles(const StudyFile& file, const Selection& selection = {});
base::Result<std::vector<study::EventRecord>> events(const StudyFile& file, const Selection& selection = {});
base::Result<std::vector<study::StrokeRecord>> strokes(const StudyFile& file, const Selection& selection = {},
                                                       Recordings recordings = Recordings::kRead);
base::Result<std::vector<study::JudgementRecord>> judgements(const StudyFile& file, const Selection& selection = {});
base::Result<std::vector<study::AnswerRecord>> answers(const StudyFile& file, const Selection& selection = {});
base::Result<std::vector<study::RatingRecord>> ratings(const StudyFile& file, const Selection& selection = {});
base::Result<std::vector<study::RuleRecord>> rules(const StudyFile& file, const Selection& selection = {});

/// The recording of one stroke; an error where its checksum does not fit.
base::Result<study::Recording> recordingOf(const StudyFile& file, const study::RecordId& stroke);

}  // namespace tactus::store
