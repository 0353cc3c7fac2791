// Another program that works on a study file with plain SQL, as the sqlite3 shell would.
#pragma once

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Statement.h>
#include <string>

#include "core/store/record_checksum.h"

namespace tactus::store {

class PlainSql {
 public:
  explicit PlainSql(const std::string& path)
      : database_(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, /*aBusyTimeoutMs=*/0) {
    addRecordChecksum(database_.getHandle());
    database_.tryExec("PRAGMA synchronous = OFF");  // what a test leaves need not survive a power cut
  }

  /// SQLite's complaint, or an empty text.
  std::string complaint(const std::string& sql) {
    try {
      database_.exec(sql);
      return {};
    } catch (const SQLite::Exception& exception) {
      return exception.what();
    }
  }
  /// The same with all guards taken away meanwhile.
  std::string complaintWithoutGuards(const std::string& sql) {
    const std::string guards = lines("SELECT sql || ';' FROM sqlite_schema WHERE type = 'trigger'");
    database_.exec(lines("SELECT 'DROP TRIGGER ' || name || ';' FROM sqlite_schema WHERE type = 'trigger'"));
    std::string result = complaint(sql);
    database_.exec(guards);
    return result;
  }
  /// SQL that makes the checksums of a table right, as one would who changes a record on purpose.
  std::string seal(const std::string& table) {
    std::string columns;
    SQLite::Statement names(database_, "SELECT name FROM pragma_table_info('" + table + "') WHERE name <> 'crc32'");
    while (names.executeStep()) columns += ", " + names.getColumn(0).getString();
    return "UPDATE " + table + " SET crc32 = record_crc32('" + table + "'" + columns + ");";
  }
  std::string text(const std::string& sql) { return database_.execAndGet(sql).getString(); }
  long long number(const std::string& sql) { return database_.execAndGet(sql).getInt64(); }
  /// All values of the first column, a line each.
  std::string lines(const std::string& sql) {
    SQLite::Statement statement(database_, sql);
    std::string out;
    while (statement.executeStep()) out += statement.getColumn(0).getString() + "\n";
    return out;
  }

 private:
  SQLite::Database database_;
};

}  // namespace tactus::store
