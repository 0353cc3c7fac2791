// Which opening for writing a study file and its journal belong to: the one row of the table `opening`.
// Private to core/store.
#pragma once

#include <SQLiteCpp/Statement.h>
#include <optional>
#include <string>

#include "core/store/connection.h"

namespace tactus::store {

/// Each opening for writing draws a token and keeps the one before; each commit counts. An orderly close says so.
struct OpeningRow {
  std::string token;     ///< 16 random bytes
  std::string previous;  ///< token of the opening before, or empty
  long long commits = 0;
  bool is_open = false;
  long long journal_bytes = 0;  ///< the journal has at least this many bytes while the study is open; 0: none promised
};

/// The row, or nothing in a file of version 1. Refuses a row that does not fit its checksum. Throws as Query does.
std::optional<OpeningRow> readOpening(Connection& connection);

/// 16 random bytes.
std::string newToken();

/// Writes the row again and again. Throws SQLite::Exception.
class OpeningWriter {
 public:
  explicit OpeningWriter(Connection& connection);
  void write(const OpeningRow& row);

 private:
  SQLite::Statement update_;
};

}  // namespace tactus::store
