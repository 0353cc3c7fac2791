// A prepared statement: values are bound and columns are read in order. Private to core/store.
#pragma once

#include <SQLiteCpp/Statement.h>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/store/connection.h"
#include "core/study/record_id.h"

namespace tactus::store {

// JSON lists of pairs of texts, as columns of a study hold them. Example, the conditions of a rule:
// `[["lubrication", "well"], ["depth", "stomach"]]`.

using PairList = std::vector<std::pair<std::string, std::string>>;

/// The list as JSON on one line.
std::string pairListText(const PairList& pairs);

/// Reads the JSON back. Nothing if `text` is anything but a list of pairs of texts.
std::optional<PairList> pairListIn(const std::string& text);

/// Throws SQLite::Exception. Throws Refusal for values that must not be stored: a number that is not finite, text that
/// is not UTF-8, a nil id.
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
  /// Binds JSON text, or an empty one.
  Query& putJson(const std::string& text);
  Query& putBlob(const std::string& bytes);

  /// Runs the statement to its end and resets it for the next values.
  void run();
  /// Moves to the next row. Returns false if there is none.
  bool next();
  /// Discards the remaining rows and resets the statement for the next values.
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
  /// Reads a column made by fitsChecksum (record_checksum.h). Refuses the record `id` of `table` if it is false.
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
