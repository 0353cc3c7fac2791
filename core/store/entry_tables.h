// The table layout of each kind of session record. Private to core/store.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/store/query.h"
#include "core/study/session_records.h"

namespace tactus::store {

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

}  // namespace tactus::store
