// The CRC-32 that each record carries, so that a changed byte is noticed when the record is read. Private to
// core/store.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

struct sqlite3;

namespace tactus::store {

class Connection;

/// Gives a connection the SQL function `record_crc32(table, value, …)`: CRC-32 of the canonical text of a row, which is
/// the table's name and then the value of each column but `crc32`, in the order of the table. A value is written as
/// `N` (NULL), `I` and the decimal number, `R` and the shortest decimal number that reads back as the same (0 without a
/// sign), `T` or `B` and the bytes of the text or blob; letter and value are one piece, and each piece follows its
/// length in bytes and a colon: `7:Tanswer5:I1760`. Not to be used by what a file itself says (DIRECTONLY).
/// Throws SQLite::Exception.
void addRecordChecksum(sqlite3* database);

/// The columns of `table` in their order, without `crc32`.
const std::vector<std::string>& columnsOf(Connection& connection, std::string_view table);

/// SQL that adds a row with its checksum. Values are the parameters ?1, ?2, … in the order of the table's columns,
/// without those that `given` names: they have an SQL expression, which may be evaluated twice.
std::string insertion(Connection& connection, std::string_view table,
                      const std::map<std::string, std::string>& given = {});

/// SQL that changes rows of `table` together with their checksums: each column of `changed` becomes what its SQL
/// expression gives. A condition is to follow (` WHERE …`). Only an unfinished erasure permits it.
std::string update(Connection& connection, std::string_view table, const std::map<std::string, std::string>& changed);

/// SQL that is true where the row `alias` of `table` fits its checksum, or was written before there were any.
/// For Query::requireIntact.
std::string fitsChecksum(Connection& connection, std::string_view table, std::string_view alias);

}  // namespace tactus::store
