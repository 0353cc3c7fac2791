#include "core/store/opening_row.h"

#include <cstdint>
#include <sqlite3.h>

#include "core/store/query.h"
#include "core/store/record_checksum.h"

namespace tactus::store {
namespace {

void bindBytes(SQLite::Statement& statement, int parameter, const std::string& bytes) {
  if (bytes.empty()) {
    statement.bind(parameter);
  } else {
    statement.bind(parameter, bytes.data(), static_cast<int>(bytes.size()));
  }
}

}  // namespace

std::optional<OpeningRow> readOpening(Connection& connection) {
  Query there(connection, "SELECT 1 FROM main.sqlite_schema WHERE type = 'table' AND name = 'opening'");
  if (!there.next()) return std::nullopt;
  Query query(connection,
              "SELECT token, previous, commits, is_open, journal_bytes, crc32 = record_crc32('opening', one, token,"
              " previous, commits, is_open, journal_bytes) FROM main.opening");
  if (!query.next()) refuse(base::ErrorCode::kMismatch, "opening", "no row", "an intact study file");
  OpeningRow row;
  row.token = query.text();
  row.previous = query.text();
  row.commits = query.integer();
  row.is_open = query.flag();
  row.journal_bytes = query.integer();
  if (!query.flag()) {
    refuse(base::ErrorCode::kMismatch, "opening", "a row that does not fit its CRC-32", "an intact study file");
  }
  return row;
}

std::string newToken() {
  std::string token(16, '\0');
  sqlite3_randomness(static_cast<int>(token.size()), token.data());
  return token;
}

OpeningWriter::OpeningWriter(Connection& connection)
    : update_(connection.database(),
              "UPDATE opening SET token = ?1, previous = ?2, commits = ?3, is_open = ?4, journal_bytes = ?5,"
              " crc32 = record_crc32('opening', one, ?1, ?2, ?3, ?4, ?5)") {}

void OpeningWriter::write(const OpeningRow& row) {
  bindBytes(update_, 1, row.token);
  bindBytes(update_, 2, row.previous);
  update_.bind(3, static_cast<std::int64_t>(row.commits));
  update_.bind(4, row.is_open ? 1 : 0);
  update_.bind(5, static_cast<std::int64_t>(row.journal_bytes));
  update_.exec();
  update_.reset();
}

}  // namespace tactus::store
