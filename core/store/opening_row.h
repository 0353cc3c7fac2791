// The opening that a study file and its journal belong to: the single row of the table `opening`. Private to
// core/store.
#pragma once

#include <SQLiteCpp/Statement.h>
#include <optional>
#include <string>

#include "core/store/connection.h"

namespace tactus::store {

/// Each opening for writing generates a token and keeps the previous one. Each commit is counted. An orderly close
/// clears `is_open`.
struct OpeningRow {
  std::string token;     ///< 16 random bytes
  std::string previous;  ///< token of the previous opening; may be empty
  long long commits = 0;
  bool is_open = false;
  long long journal_bytes = 0;  ///< minimum length of the journal in bytes while the study is open; 0: none stated
};

/// The row; nothing in a file of version 1. Refuses a row with a wrong checksum. Throws as Query does.
std::optional<OpeningRow> readOpening(Connection& connection);

/// 16 random bytes.
std::string newToken();

/// Writes the row repeatedly. Throws SQLite::Exception.
class OpeningWriter {
 public:
  explicit OpeningWriter(Connection& connection);
  void write(const OpeningRow& row);

 private:
  SQLite::Statement update_;
};

}  // namespace tactus::store
