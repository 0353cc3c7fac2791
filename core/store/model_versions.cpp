#include "core/store/model_versions.h"

#include "core/base/files/checksums.h"
#include "core/model_io/expert_removal.h"
#include "core/store/query.h"
#include "core/store/record_checksum.h"
#include "core/store/withdrawn_codes.h"

namespace tactus::store {
namespace {

using base::ErrorCode;
using base::Result;
using study::ModelVersion;
using study::RecordId;

/// What readVersion takes, of a version called `m`.
std::string versionColumns(Connection& connection) {
  return "m.id, m.parent, m.utc_ms, m.author, m.label, m.sha256, " + fitsChecksum(connection, "model_version", "m");
}
std::string versionColumnsWithText(Connection& connection) {
  return "m.id, m.parent, m.utc_ms, m.author, m.label, m.sha256, m.text, " +
         fitsChecksum(connection, "model_version", "m");
}

ModelVersion readColumns(Query& query) {
  ModelVersion version;
  version.id = query.id();
  version.parent = query.idOrNothing();
  version.utc_ms = query.integer();
  version.author = query.text();
  version.label = query.text();
  version.sha256 = query.text();
  return version;
}

ModelVersion readVersion(Query& query) {
  ModelVersion version = readColumns(query);
  query.requireIntact("model version", version.id);
  return version;
}

ModelVersion readVersionWithText(Query& query) {
  ModelVersion version = readColumns(query);
  version.text = query.text();
  if (base::sha256(version.text) != version.sha256) {
    refuse(ErrorCode::kMismatch, "model version " + study::toText(version.id), "a text with another SHA-256",
           "the text that was stored");
  }
  query.requireIntact("model version", version.id);
  return version;
}

/// A model that was open elsewhere while its expert withdrew must not bring the rules back.
void refuseWithdrawnExperts(Connection& connection, const std::string& text) {
  const auto withdrawn = readTombstones(connection);
  if (withdrawn.empty()) return;
  for (const std::string& expert : model_io::expertIds(text)) {
    const TombstoneRow* const row = withdrawnWith(withdrawn, expert);
    if (row == nullptr || codesOfNobodyElse(connection, row->person, {expert}).empty()) continue;
    refuse(ErrorCode::kValue, "model version", "an expert with " + describeWithdrawn(expert, *row),
           "a model without this expert");
  }
}

std::vector<ModelVersion> readVersions(Query& query) {
  std::vector<ModelVersion> versions;
  while (query.next()) versions.push_back(readVersion(query));
  return versions;
}

}  // namespace

Result<void> append(StudyFile& file, const ModelVersion& version) {
  Connection& connection = file.connection();
  return inTransaction(connection, [&] {
    const std::string hash = base::sha256(version.text);
    if (!version.sha256.empty() && version.sha256 != hash) {
      refuse(ErrorCode::kMismatch, "model version", "the SHA-256 " + base::quoted(version.sha256), hash);
    }
    refuseWithdrawnExperts(connection, version.text);
    Query insert(connection, insertion(connection, "model_version",
                                       {{"place", "(SELECT coalesce(max(place), 0) + 1 FROM model_version)"},
                                        {"sequence", "(SELECT coalesce(max(sequence), 0) + 1 FROM model_version)"},
                                        {"cleaned_utc_ms", "NULL"}}));
    insert.put(version.id).put(version.parent).put(version.utc_ms).put(version.author).put(version.label);
    insert.put(hash).put(version.text).run();
  });
}

Result<std::vector<ModelVersion>> modelVersions(const StudyFile& file) {
  Connection& connection = file.connection();
  return guarded(connection, [&] {
    Query query(connection, "SELECT " + versionColumns(connection) +
                                " FROM model_version AS m ORDER BY m.sequence, m.utc_ms, m.id");
    return readVersions(query);
  });
}

Result<ModelVersion> modelVersion(const StudyFile& file, const RecordId& id) {
  Connection& connection = file.connection();
  return guarded(connection, [&] {
    Query query(connection, "SELECT " + versionColumnsWithText(connection) + " FROM model_version AS m WHERE m.id = ?");
    if (!query.put(id).next()) {
      refuse(ErrorCode::kReference, {}, "no model version " + study::toText(id), "the id of one in the study");
    }
    return readVersionWithText(query);
  });
}

Result<std::optional<ModelVersion>> latestModelVersion(const StudyFile& file) {
  Connection& connection = file.connection();
  return guarded(connection, [&]() -> std::optional<ModelVersion> {
    Query query(connection, "SELECT " + versionColumnsWithText(connection) +
                                " FROM model_version AS m"
                                " ORDER BY m.sequence DESC, m.utc_ms DESC, m.id DESC LIMIT 1");
    if (!query.next()) return std::nullopt;
    return readVersionWithText(query);
  });
}

Result<std::vector<ModelVersion>> modelAncestors(const StudyFile& file, const RecordId& id) {
  Connection& connection = file.connection();
  return guarded(connection, [&] {
    // UNION, not UNION ALL: a circle in a damaged file would never end.
    Query query(connection, std::string("WITH RECURSIVE line(id, depth) AS ("
                                        " SELECT parent, 1 FROM model_version WHERE id = ?1"
                                        " UNION SELECT m.parent, depth + 1 FROM line JOIN model_version AS m USING (id)"
                                        "  WHERE depth <= (SELECT count(*) FROM model_version))"
                                        " SELECT ") +
                                versionColumns(connection) +
                                " FROM line JOIN model_version AS m ON m.id = line.id ORDER BY line.depth");
    return readVersions(query.put(id));
  });
}

}  // namespace tactus::store
