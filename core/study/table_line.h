// Where a record of a study stands in its CSV table, so that an error can name the line that a person has to change.
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

/// The line of a record's table. It says nothing of what the record holds, so any two lines are equal.
struct TableLine {
  std::uint32_t number = 0;  ///< from 1; 0 where the record comes from no table

  bool operator==(const TableLine&) const { return true; }
};

/// A cell of one of the tables above.
struct TableCell {
  std::string_view table;
  TableLine line;
  std::string_view column;
};

/// `error` about a record that may come from a table. If it does, the error names the table (Error::file, without the
/// folder), line and column, and what was found is `found`; otherwise the error stays as it is.
tl::unexpected<base::Error> atCell(base::Error error, const TableCell& cell, std::string found);

/// `error` about records of `table` as a whole, where a record of it has the line `line`: names the table if there is
/// one.
tl::unexpected<base::Error> inTable(base::Error error, std::string_view table, TableLine line);

/// The same error with `folder` before the table that it names; an error that names no table is about the folder.
tl::unexpected<base::Error> inStudyFolder(base::Error error, const std::string& folder);

}  // namespace tactus::study
