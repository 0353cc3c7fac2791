// The place of a study's record in its CSV table, so that an error can name the line to correct.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace tactus::study {

inline constexpr std::string_view kParticipantsTable = "participants.csv";
inline constexpr std::string_view kSpeedsTable = "speeds.csv";
inline constexpr std::string_view kJudgementsTable = "judgements.csv";
inline constexpr std::string_view kAnswersTable = "answers.csv";
inline constexpr std::string_view kRulesTable = "rules.csv";

/// The line of a record in its table. It is not part of the record's content, so any two lines compare equal.
struct TableLine {
  std::uint32_t number = 0;  ///< from 1; 0 if the record does not come from a table

  bool operator==(const TableLine&) const { return true; }
};

/// A cell of one of the tables above.
struct TableCell {
  std::string_view table;
  TableLine line;
  std::string_view column;
};

/// Adds table, line and column to `error`, if the record comes from a table. The error then names the table
/// (Error::file, without folder), and `found` replaces its found text. Otherwise the error is unchanged.
tl::unexpected<base::Error> atCell(base::Error error, const TableCell& cell, std::string found);

/// Adds the table to an `error` about records of `table` as a whole. `line`: the line of one of these records; if it is
/// 0, the error is unchanged.
tl::unexpected<base::Error> inTable(base::Error error, std::string_view table, TableLine line);

/// Puts `folder` in front of the table that the error names. An error without a table becomes one about the folder.
tl::unexpected<base::Error> inStudyFolder(base::Error error, const std::string& folder);

}  // namespace tactus::study
