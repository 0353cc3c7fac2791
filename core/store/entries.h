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
#include "core/store/query.h"
#include "core/store/study_file.h"
#include "core/study/session_records.h"

namespace tactus::store {

// The table layout of each kind of session record. Private to core/store.

/// The tables whose rows begin with the columns of study::Entry.
inline constexpr std::array<std::string_view, 7> kEntryTables = {"profile", "event",  "stroke", "judgement",
                                                                 "answer",  "rating", "rule"};

/// A table and its columns after those of study::Entry.
struct EntryTable {
  std::string_view name;
  std::string_view columns;
};

template <class Record>
inline constexpr EntryTable kEntryTable{};
template <>
inline constexpr EntryTable kEntryTable<study::ProfileRecord>{
    "profile",
    "years_experience, insertions_per_month, category, handedness, gloves, tube_size, "
    "haptic_experience, weight, comfort"};
template <>
inline constexpr EntryTable kEntryTable<study::EventRecord>{"event", "kind, detail"};
template <>
inline constexpr EntryTable kEntryTable<study::StrokeRecord>{
    "stroke", "level, number, attempt, practice, verdict, first_sample, end_sample"};
template <>
inline constexpr EntryTable kEntryTable<study::JudgementRecord>{
    "judgement",
    "series, step, attempt, commanded_n, felt_n, kind, term, scored, catch_trial, feel_again, "
    "forward_mm, forward_speed_mm_s, response_s, delivered_share"};
template <>
inline constexpr EntryTable kEntryTable<study::AnswerRecord>{
    "answer", "form, form_version, item, position, status, value, response_s, wording"};
template <>
inline constexpr EntryTable kEntryTable<study::RatingRecord>{"rating", "block, effort, comfort"};
template <>
inline constexpr EntryTable kEntryTable<study::RuleRecord>{"rule", "form, conditions, then_term, weight"};

/// The columns of a row, in order.
void putColumns(Query& query, const study::ProfileRecord& record);
void putColumns(Query& query, const study::EventRecord& record);
void putColumns(Query& query, const study::StrokeRecord& record);
void putColumns(Query& query, const study::JudgementRecord& record);
void putColumns(Query& query, const study::AnswerRecord& record);
void putColumns(Query& query, const study::RatingRecord& record);
void putColumns(Query& query, const study::RuleRecord& record);

void takeColumns(Query& query, study::ProfileRecord& record);
void takeColumns(Query& query, study::EventRecord& record);
void takeColumns(Query& query, study::StrokeRecord& record);
void takeColumns(Query& query, study::JudgementRecord& record);
void takeColumns(Query& query, study::AnswerRecord& record);
void takeColumns(Query& query, study::RatingRecord& record);
void takeColumns(Query& query, study::RuleRecord& record);

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
