#include "core/store/removal.h"

#include <string>
#include <string_view>

#include "core/store/entry_tables.h"
#include "core/store/query.h"

namespace tactus::store {

using study::RecordId;

namespace {

/// Deletes and counts. The triggers allow it because the tombstone stands.
long long removeRows(Connection& connection, const std::string& table, const std::string& condition,
                     const RecordId& person) {
  Query remove(connection, "DELETE FROM " + table + " WHERE " + condition);
  remove.put(person).run();
  return connection.database().getChanges();
}

}  // namespace

long long removePerson(Connection& connection, const RecordId& person) {
  const std::string in_sessions = "session_id IN (SELECT id FROM session WHERE person_id = ?1)";
  long long records = 0;
  removeRows(connection, "recording", in_sessions, person);  // part of a stroke, not counted
  for (const std::string_view table : kEntryTables) {
    records += removeRows(connection, std::string(table), in_sessions, person);
  }
  removeRows(connection, "person_code", "person_id = ?1", person);  // part of the person, not counted
  records += removeRows(connection, "session", "person_id = ?1", person);
  return records + removeRows(connection, "person", "id = ?1", person);
}

}  // namespace tactus::store
