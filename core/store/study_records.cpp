#include "core/store/study_records.h"

#include <algorithm>

#include "core/base/json/json_document.h"
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

namespace {

using base::ErrorCode;
using base::Result;
using study::DepthRecord;
using study::RecordId;

constexpr std::string_view kDepthTable = "depth_measurement";

/// The image that the record `id` holds; empty if it holds none.
std::string imageOf(Connection& connection, const RecordId& id) {
  Query query(connection, "SELECT coalesce(d.image, x''), " + fitsChecksum(connection, kDepthTable, "d") +
                              " FROM depth_measurement AS d WHERE d.id = ?");
  if (!query.put(id).next()) return {};
  std::string image = query.text();
  query.requireIntact(kDepthTable, id);
  return image;
}

std::optional<DepthRecord> readLatest(Connection& connection) {
  Query query(connection, "SELECT d.id, d.utc_ms, d.author, d.text, d.image_id, " +
                              fitsChecksum(connection, kDepthTable, "d") +
                              " FROM depth_measurement AS d ORDER BY d.utc_ms DESC, d.id DESC LIMIT 1");
  if (!query.next()) return std::nullopt;
  DepthRecord record;
  record.id = query.id();
  record.utc_ms = query.integer();
  record.author = query.text();
  record.text = query.text();
  record.image_of = query.idOrNothing();
  query.requireIntact(kDepthTable, record.id);
  record.image = imageOf(connection, record.image_of.value_or(record.id));
  return record;
}

}  // namespace

Result<void> append(StudyFile& file, const DepthRecord& record) {
  Connection& connection = file.connection();
  return inTransaction(connection, [&] {
    if (!record.text.starts_with('{') || !base::JsonDocument::parse(record.text)) {
      refuse(ErrorCode::kSyntax, std::string(kDepthTable), base::quoted(record.text), "a JSON object");
    }
    if (record.image.size() > kMostImageBytes) {
      refuse(ErrorCode::kLimit, std::string(kDepthTable),
             "an image of " + std::to_string(record.image.size()) + " bytes",
             "at most " + std::to_string(kMostImageBytes));
    }
    if (record.image_of && (!record.image.empty() || imageOf(connection, *record.image_of).empty())) {
      refuse(ErrorCode::kReference, std::string(kDepthTable),
             "an image of another record that is not there, or a second one", "the record with which the image came");
    }
    Query insert(connection, insertion(connection, kDepthTable));
    insert.put(record.id).put(record.utc_ms).put(record.author).putJson(record.text).put(record.image_of);
    if (record.image.empty()) {
      insert.put(std::optional<RecordId>());
    } else {
      insert.putBlob(record.image);
    }
    insert.run();
  });
}

Result<std::optional<DepthRecord>> depthMeasurement(const StudyFile& file) {
  Connection& connection = file.connection();
  return guarded(connection, [&] { return readLatest(connection); });
}

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
