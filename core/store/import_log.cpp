#include "core/store/import_log.h"

#include "core/store/query.h"
#include "core/store/record_checksum.h"

namespace tactus::store {

using base::Result;

Result<void> append(StudyFile& file, const ImportLogEntry& entry) {
  Connection& connection = file.connection();
  return inTransaction(connection, [&] {
    Query log(connection, insertion(connection, "import_log"));
    log.put(entry.id).put(entry.utc_ms).put(entry.kind).put(entry.source).put(entry.detail).put(entry.sha256).run();
  });
}

Result<std::vector<ImportLogEntry>> importLog(const StudyFile& file) {
  Connection& connection = file.connection();
  return guarded(connection, [&] {
    Query query(connection, "SELECT id, utc_ms, kind, source, detail, sha256 FROM import_log ORDER BY utc_ms, id");
    std::vector<ImportLogEntry> entries;
    while (query.next()) {
      ImportLogEntry entry;
      entry.id = query.id();
      entry.utc_ms = query.integer();
      entry.kind = query.text();
      entry.source = query.text();
      entry.detail = query.text();
      entry.sha256 = query.text();
      entries.push_back(std::move(entry));
    }
    return entries;
  });
}

}  // namespace tactus::store
