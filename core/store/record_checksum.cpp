#include "core/store/record_checksum.h"

#include <SQLiteCpp/Exception.h>
#include <algorithm>
#include <array>
#include <charconv>
#include <sqlite3.h>

#include "core/base/files/checksums.h"
#include "core/base/text.h"
#include "core/store/query.h"

namespace tactus::store {
namespace {

constexpr std::string_view kChecksum = "crc32";

void addPiece(base::Crc32& crc, char letter, std::string_view bytes) {
  std::array<char, 24> begin{};
  char* end = std::to_chars(begin.data(), begin.data() + begin.size() - 2, bytes.size() + 1).ptr;
  *end++ = ':';
  *end++ = letter;
  crc.add({begin.data(), static_cast<std::size_t>(end - begin.data())}).add(bytes);
}

void addValue(base::Crc32& crc, sqlite3_value* value) {
  std::array<char, 32> text{};
  const auto written = [&](std::to_chars_result result) {
    return std::string_view(text.data(), static_cast<std::size_t>(result.ptr - text.data()));
  };
  switch (sqlite3_value_type(value)) {
    case SQLITE_INTEGER:
      return addPiece(crc, 'I', written(std::to_chars(text.begin(), text.end(), sqlite3_value_int64(value))));
    case SQLITE_FLOAT: {
      // SQLite stores a whole number as an integer, which has no negative zero.
      const double number = sqlite3_value_double(value);
      return addPiece(crc, 'R', written(std::to_chars(text.begin(), text.end(), number == 0 ? 0.0 : number)));
    }
    case SQLITE_TEXT: {
      const auto* bytes = reinterpret_cast<const char*>(sqlite3_value_text(value));
      return addPiece(crc, 'T', {bytes, static_cast<std::size_t>(sqlite3_value_bytes(value))});
    }
    case SQLITE_BLOB: {
      const auto* bytes = static_cast<const char*>(sqlite3_value_blob(value));
      return addPiece(crc, 'B', {bytes, static_cast<std::size_t>(sqlite3_value_bytes(value))});
    }
    default: return addPiece(crc, 'N', {});
  }
}

void recordChecksum(sqlite3_context* context, int count, sqlite3_value** values) {
  base::Crc32 crc;
  for (int i = 0; i < count; ++i) addValue(crc, values[i]);
  sqlite3_result_int64(context, crc.value());
}

}  // namespace

void addRecordChecksum(sqlite3* database) {
  const int flags = SQLITE_UTF8 | SQLITE_DETERMINISTIC | SQLITE_DIRECTONLY;
  const int code = sqlite3_create_function_v2(database, "record_crc32", -1, flags, nullptr, recordChecksum, nullptr,
                                              nullptr, nullptr);
  if (code != SQLITE_OK) throw SQLite::Exception(database, code);
}

const std::vector<std::string>& columnsOf(Connection& connection, std::string_view table) {
  auto& columns = connection.columns()[std::string(table)];
  if (columns.empty()) {
    Query query(connection, "SELECT name FROM pragma_table_info(?) ORDER BY cid");
    query.put(table);
    while (query.next()) columns.push_back(query.text());
    columns.erase(std::remove(columns.begin(), columns.end(), kChecksum), columns.end());
  }
  return columns;
}

std::string insertion(Connection& connection, std::string_view table, const std::map<std::string, std::string>& given) {
  std::string names;
  std::string values;
  int parameter = 0;
  for (const auto& column : columnsOf(connection, table)) {
    names.append(column).append(", ");
    const auto found = given.find(column);
    values.append(found != given.end() ? found->second : '?' + std::to_string(++parameter)).append(", ");
  }
  const std::string name(table);
  const std::string arguments = values.substr(0, values.size() - 2);
  return "INSERT INTO " + name + " (" + names + "crc32) VALUES (" + values + "record_crc32('" + name + "', " +
         arguments + "))";
}

std::string update(Connection& connection, std::string_view table, const std::map<std::string, std::string>& changed) {
  std::string changes;
  for (const auto& [column, value] : changed) changes.append(column).append(" = ").append(value).append(", ");
  std::string sum = "record_crc32('" + std::string(table) + "'";
  for (const auto& column : columnsOf(connection, table)) {
    const auto found = changed.find(column);
    sum.append(", ").append(found != changed.end() ? found->second : column);
  }
  return "UPDATE " + std::string(table) + " SET " + changes + "crc32 = " + sum + ")";
}

std::string fitsChecksum(Connection& connection, std::string_view table, std::string_view alias) {
  const std::string row = std::string(alias) + '.';
  std::string sql = "(" + row + "crc32 IS NULL OR " + row + "crc32 = record_crc32('" + std::string(table) + "'";
  for (const auto& column : columnsOf(connection, table)) sql.append(", ").append(row).append(column);
  return sql + "))";
}

}  // namespace tactus::store
