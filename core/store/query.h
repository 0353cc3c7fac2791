// A prepared statement whose values go in and come out in order. Private to core/store.
#pragma once

#include <SQLiteCpp/Statement.h>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/store/connection.h"
#include "core/study/record_id.h"

namespace tactus::store {

/// Throws SQLite::Exception, and Refusal for what must not be stored: a number that is not finite, text that is not
/// UTF-8, an id that names nothing.
class Query {
 public:
  Query(Connection& connection, const std::string& sql)
      : own_(std::in_place, connection.database(), sql), statement_(*own_) {}
  Query(const Query&) = delete;
  Query& operator=(const Query&) = delete;

  /// Binds the next parameter.
  Query& put(std::int64_t value);
  Query& put(int value) { return put(static_cast<std::int64_t>(value)); }
  Query& put(bool value) { return put(static_cast<std::int64_t>(value)); }
  Query& put(double value);
  Query& put(const std::optional<double>& value);
  Query& put(const std::optional<std::int64_t>& value);
  Query& put(std::string_view text);
  Query& put(const std::string& text) { return put(std::string_view(text)); }
  Query& put(const char* text) { return put(std::string_view(text)); }
  Query& put(const study::RecordId& id);
  Query& put(const std::optional<study::RecordId>& id);
  /// JSON text, or an empty one.
  Query& putJson(const std::string& text);
  Query& putBlob(const std::string& bytes);

  /// Runs to the end and makes ready for the next set of values.
  void run();
  /// Goes to the next row, if there is one.
  bool next();
  /// Forgets the rows that were not taken, and makes ready for the next set of values.
  void reset();

  /// The next column of the row.
  std::int64_t integer() { return statement_.getColumn(out_++).getInt64(); }
  int small() { return static_cast<int>(integer()); }
  bool flag() { return integer() != 0; }
  double number() { return statement_.getColumn(out_++).getDouble(); }
  std::optional<double> numberOrNothing();
  std::optional<std::int64_t> integerOrNothing();
  std::string text() { return statement_.getColumn(out_++).getString(); }
  study::RecordId id();
  /// Takes a column of fitsChecksum (record_checksum.h); refuses the record `id` of `table` where it is false.
  void requireIntact(std::string_view table, const study::RecordId& id);
  std::optional<study::RecordId> idOrNothing();

 protected:
  /// A statement that stays the caller's.
  explicit Query(SQLite::Statement& statement) : statement_(statement) {}
  void giveBack();

 private:
  std::optional<SQLite::Statement> own_;
  SQLite::Statement& statement_;
  int in_ = 1;
  int out_ = 0;
};

/// A query that the connection prepares once and keeps: for what every commit does. At most one of the same text at a
/// time.
class KeptQuery : public Query {
 public:
  KeptQuery(Connection& connection, const std::string& sql) : Query(connection.kept(sql)) {}
  ~KeptQuery() { giveBack(); }
};

}  // namespace tactus::store
