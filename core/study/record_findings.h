// Findings about a record of a study: where it stands in its table, and whose it is.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "core/study/data_finding.h"
#include "core/study/records.h"
#include "core/study/table_line.h"

namespace tactus::study {

inline TableCell cellOf(const Participant& record, std::string_view column) {
  return {kParticipantsTable, record.line, column};
}
inline TableCell cellOf(const SpeedSample& record, std::string_view column) {
  return {kSpeedsTable, record.line, column};
}
inline TableCell cellOf(const ForceJudgement& record, std::string_view column) {
  return {kJudgementsTable, record.line, column};
}
inline TableCell cellOf(const Answer& record, std::string_view column) { return {kAnswersTable, record.line, column}; }
inline TableCell cellOf(const GivenRule& record, std::string_view column) { return {kRulesTable, record.line, column}; }

inline const std::string& codeOf(const Participant& record) { return record.code; }
template <class Record>
const std::string& codeOf(const Record& record) {
  return record.participant;
}

/// A note or a warning about `record`; for what is refused: `refusal`.
template <class Record>
DataFinding remark(DataFinding::Kind kind, DataFinding::Severity severity, const Record& record,
                   std::string_view column, std::string sentence) {
  return {kind, severity, codeOf(record), cellOf(record, column), std::move(sentence), {}, {}};
}

}  // namespace tactus::study
