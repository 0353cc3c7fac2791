#include "core/store/schema_check.h"

#include <algorithm>
#include <map>

#include "core/store/query.h"
#include "core/store/record_checksum.h"
#include "core/store/record_tables.h"
#include "core/store/schema.h"

namespace tactus::store {
namespace {

using base::ErrorCode;

/// The SQL of each table, index, view and trigger, by type and name. Indexes that SQLite makes by itself have none.
using Schema = std::map<std::string, std::string>;

Schema schemaOf(SQLite::Database& database) {
  SQLite::Statement rows(database,
                         "SELECT type || ' ' || name || ' of ' || tbl_name, coalesce(sql, '') FROM main.sqlite_schema"
                         " WHERE NOT (type = 'table' AND name = 'sqlite_stat1')");
  Schema schema;
  while (rows.executeStep()) schema[rows.getColumn(0).getString()] = rows.getColumn(1).getString();
  return schema;
}

/// The schema of each version, from 1: what its steps make of an empty database.
const std::vector<Schema>& knownSchemas() {
  static const std::vector<Schema> schemas = [] {
    SQLite::Database database(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    addRecordChecksum(database.getHandle());
    std::vector<Schema> made;
    for (const Migration& step : schemaSteps()) {
      database.exec("BEGIN");
      database.exec(step.sql);
      database.exec("COMMIT");
      made.push_back(schemaOf(database));
    }
    return made;
  }();
  return schemas;
}

[[noreturn]] void refuseSchema(const std::string& found, int version) {
  refuse(ErrorCode::kSchema, {}, found,
         "the tables of a study of version " + std::to_string(version) + " as Tactus makes them");
}

void requireOrdinaryTables(const Schema& found, int version) {
  for (const RecordTable& table : recordTables()) {
    const std::string name(table.name);
    const auto at = found.find("table " + name + " of " + name);
    if (at == found.end() || !at->second.starts_with("CREATE TABLE")) refuseSchema("no table " + name, version);
  }
}

}  // namespace

void requireSchema(Connection& connection, int version) {
  const Schema found = schemaOf(connection.database());
  if (version > static_cast<int>(knownSchemas().size())) return requireOrdinaryTables(found, version);
  const Schema& wanted = knownSchemas()[static_cast<std::size_t>(version) - 1];
  if (found == wanted) return;
  for (const auto& [object, sql] : wanted) {
    const auto at = found.find(object);
    if (at == found.end()) refuseSchema("no " + object, version);
    if (at->second != sql) refuseSchema("another " + object, version);
  }
  for (const auto& [object, sql] : found) {
    if (!wanted.contains(object)) refuseSchema("a foreign object (" + base::quoted(object) + ")", version);
  }
}

}  // namespace tactus::store
