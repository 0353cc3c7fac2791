#include "core/store/depth_records.h"

#include "core/base/json/json_document.h"
#include "core/store/query.h"
#include "core/store/record_checksum.h"

namespace tactus::store {
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

}  // namespace tactus::store
