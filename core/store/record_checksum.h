// The CRC-32 of each record, which detects a changed byte when the record is read. Private to core/store.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

struct sqlite3;

namespace tactus::store {

class Connection;

/// Adds the SQL function `record_crc32(table, value, …)` to a connection. It is the CRC-32 of the canonical text of a
/// row: the table's name, then the value of each column except `crc32`, in the order of the table.
/// A value is written as `N` (NULL), `I` and the decimal number, `R` and the shortest decimal number that reads back
/// equal (0 without a sign), `T` or `B` and the bytes of the text or blob. Letter and value form one piece. Each piece
/// follows its length in bytes and a colon: `7:Tanswer5:I1760`.
/// SQL stored in the file cannot call the function (DIRECTONLY). Throws SQLite::Exception.
void addRecordChecksum(sqlite3* database);

/// The columns of `table` in their order, without `crc32`.
const std::vector<std::string>& columnsOf(Connection& connection, std::string_view table);

/// SQL that inserts a row with its checksum. The parameters ?1, ?2, … are the values in the order of the table's
/// columns, without the columns in `given`. `given`: column name to SQL expression, which may be evaluated twice.
std::string insertion(Connection& connection, std::string_view table,
                      const std::map<std::string, std::string>& given = {});

/// SQL that changes rows of `table` and their checksums: each column in `changed` gets the value of its SQL expression.
/// The caller appends a condition (` WHERE …`). The guards allow it only during an unfinished erasure.
std::string update(Connection& connection, std::string_view table, const std::map<std::string, std::string>& changed);

/// SQL that is true if the row `alias` of `table` matches its checksum, or was written before checksums existed. For
/// Query::requireIntact.
std::string fitsChecksum(Connection& connection, std::string_view table, std::string_view alias);

}  // namespace tactus::store
