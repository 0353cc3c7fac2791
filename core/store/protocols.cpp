#include "core/store/protocols.h"

#include <algorithm>

#include "core/base/json/json_document.h"
#include "core/store/query.h"
#include "core/store/record_checksum.h"

namespace tactus::store {
namespace {

using base::ErrorCode;
using base::Result;
using study::ProtocolRecord;

std::vector<ProtocolRecord> readProtocols(Connection& connection) {
  Query query(connection, "SELECT p.id, p.version, p.utc_ms, p.author, p.reason, p.text, " +
                              fitsChecksum(connection, "protocol", "p") +
                              " FROM protocol AS p ORDER BY p.version, p.utc_ms, p.id");
  std::vector<ProtocolRecord> found;
  while (query.next()) {
    ProtocolRecord record;
    record.id = query.id();
    record.version = query.small();
    record.utc_ms = query.integer();
    record.author = query.text();
    record.reason = query.text();
    record.text = query.text();
    query.requireIntact("protocol", record.id);
    found.push_back(std::move(record));
  }
  return found;
}

bool isFollowed(Connection& connection, int version) {
  Query query(connection,
              "SELECT 1 FROM session AS s JOIN protocol AS p ON p.id = s.protocol_id JOIN person ON person.id = "
              "s.person_id WHERE p.version = ? AND person.simulated = 0");
  return query.put(version).next();
}

ProtocolState readState(Connection& connection) {
  auto all = readProtocols(connection);
  if (all.empty()) return {};
  const bool locked = isFollowed(connection, all.back().version);
  return {std::move(all.back()), locked};
}

}  // namespace

Result<ProtocolState> protocolState(const StudyFile& file) {
  Connection& connection = file.connection();
  return guarded(connection, [&] { return readState(connection); });
}

Result<void> append(StudyFile& file, const ProtocolRecord& record) {
  Connection& connection = file.connection();
  return inTransaction(connection, [&] {
    const ProtocolState state = readState(connection);
    if (record.version != state.nextVersion()) {
      refuse(ErrorCode::kValue, "protocol", "version " + std::to_string(record.version),
             "version " + std::to_string(state.nextVersion()) +
                 (state.locked ? ", because participants follow the one before" : ""));
    }
    if (state.locked && record.reason.empty()) {
      refuse(ErrorCode::kValue, "protocol", "an amendment without a reason",
             "the reason, because participants follow version " + std::to_string(state.current->version));
    }
    if (!record.text.starts_with('{') || !base::JsonDocument::parse(record.text)) {
      refuse(ErrorCode::kSyntax, "protocol", base::quoted(record.text), "a JSON object");
    }
    Query insert(connection, insertion(connection, "protocol"));
    insert.put(record.id).put(record.version).put(record.utc_ms).put(record.author).put(record.reason);
    insert.putJson(record.text).run();
  });
}

Result<std::vector<ProtocolRecord>> protocols(const StudyFile& file) {
  Connection& connection = file.connection();
  return guarded(connection, [&] { return readProtocols(connection); });
}

}  // namespace tactus::store
