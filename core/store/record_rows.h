// Inserts the rows of one CSV table of a full export into its database table. Private to core/store.
#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include "core/base/tables/csv.h"
#include "core/store/connection.h"
#include "core/store/query.h"
#include "core/store/record_tables.h"

namespace tactus::store {

/// Throws SQLite::Exception if the file fails, and Refusal with table, line and column for invalid data.
class RecordRows {
 public:
  /// Reads the table in `folder`. `version`: schema version of the exported study.
  RecordRows(const RecordTable& table, const std::string& folder, int version);

  const base::CsvTable& csv() const { return csv_; }

  /// Inserts all rows within the open transaction. A correction is inserted after the record it corrects, regardless of
  /// their order in the CSV table.
  void insert(Connection& connection);

  [[noreturn]] void refuseCell(std::size_t row, const RecordColumn& column, std::string wanted) const;

 private:
  void insertRow(Connection& connection, Query& query, std::size_t row);
  void putCell(Query& query, std::size_t row, const RecordColumn& column);
  void putRecording(Query& query, std::size_t row, const RecordColumn& column);
  /// Binds a column that tables of this version lack.
  static void putNothing(Query& query, const RecordColumn& column);
  void requireReferences(Connection& connection, std::size_t row) const;
  std::string cell(std::size_t row, const RecordColumn& column) const;
  std::optional<study::RecordId> idIn(std::size_t row, const RecordColumn& column) const;
  std::int64_t integerIn(std::size_t row, const RecordColumn& column) const;
  /// The row's own file below the folder. The cell must hold exactly this name.
  std::string ownFile(std::size_t row, const RecordColumn& column, std::string_view below,
                      std::string_view ending) const;

  const RecordTable& table_;
  std::string folder_;
  int version_;
  base::CsvTable csv_;
};

/// The value of `result`. Throws its error as a Refusal.
template <class Value>
Value orRefuse(base::Result<Value> result) {
  if (!result) throw Refusal{std::move(result.error())};
  if constexpr (!std::is_void_v<Value>) return *std::move(result);
}

}  // namespace tactus::store
