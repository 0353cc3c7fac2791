// The records of sessions: actions and statements of participants. They can be added and read, never changed.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"

namespace tactus::store {

// The table layout of each kind of session record. Private to core/store.

/// The tables whose rows begin with the columns of study::Entry.
inline constexpr std::array<std::string_view, 7> kEntryTables = {"profile", "event",  "stroke", "judgement",
                                                                 "answer",  "rating", "rule"};

/// Adds a record to its session, in a transaction of its own; on success it is committed and synced. Returns an error
/// and writes nothing for: an existing id, an unknown session, a number that is not finite or outside its range, a
/// correction of a record that already has one or that belongs to another person.
base::Result<void> append(StudyFile& file, const study::ProfileRecord& record);
base::Result<void> append(StudyFile& file, const study::EventRecord& record);
base::Result<void> append(StudyFile& file, const study::StrokeRecord& record);
base::Result<void> append(StudyFile& file, const study::JudgementRecord& record);
base::Result<void> append(StudyFile& file, const study::AnswerRecord& record);
base::Result<void> append(StudyFile& file, const study::RatingRecord& record);
base::Result<void> append(StudyFile& file, const study::RuleRecord& record);

/// A selection of records: all given conditions must hold.
struct Selection {
  std::optional<study::RecordId> person = {};
  std::optional<study::RecordId> session = {};
  /// Include the records that were corrected.
  bool history = false;
};

enum class Recordings {
  kRead,
  kLeaveOut,  ///< strokes without samples: fast for lists
};

/// The selected records: sessions by start time, records of a session in the order of insertion.
base::Result<std::vector<study::ProfileRecord>> profiles(const StudyFile& file, const Selection& selection = {});
base::Result<std::vector<study::EventRecord>> events(const StudyFile& file, const Selection& selection = {});
base::Result<std::vector<study::StrokeRecord>> strokes(const StudyFile& file, const Selection& selection = {},
                                                       Recordings recordings = Recordings::kRead);
base::Result<std::vector<study::JudgementRecord>> judgements(const StudyFile& file, const Selection& selection = {});
base::Result<std::vector<study::AnswerRecord>> answers(const StudyFile& file, const Selection& selection = {});
base::Result<std::vector<study::RatingRecord>> ratings(const StudyFile& file, const Selection& selection = {});
base::Result<std::vector<study::RuleRecord>> rules(const StudyFile& file, const Selection& selection = {});

/// The place of each record in its session: 1, 2, 3, … over all kinds, corrected records included.
base::Result<std::map<study::RecordId, std::int64_t>> sequences(const StudyFile& file);

/// The recording of one stroke. Returns an error if its checksum does not match.
base::Result<study::Recording> recordingOf(const StudyFile& file, const study::RecordId& stroke);

}  // namespace tactus::store
