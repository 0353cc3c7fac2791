// Another program that works on a study file with plain SQL, as the sqlite3 shell would.
#pragma once

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Statement.h>
#include <string>

namespace tactus::store {

class PlainSql {
 public:
  explicit PlainSql(const std::string& path)
      : database_(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, /*aBusyTimeoutMs=*/0) {}

  /// SQLite's complaint, or an empty text.
  std::string complaint(const std::string& sql) {
    try {
      database_.exec(sql);
      return {};
    } catch (const SQLite::Exception& exception) {
      return exception.what();
    }
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
