#include "core/store/study_info.h"

#include <utility>

#include "core/base/files/checksums.h"
#include "core/store/duel_records.h"
#include "core/store/entries.h"
#include "core/store/feel_records.h"
#include "core/store/merge.h"
#include "core/store/query.h"
#include "core/store/record_checksum.h"
#include "core/store/record_tables.h"
#include "core/store/recording_codec.h"
#include "core/store/sealed_references.h"
#include "core/store/study_records.h"
#include "core/store/withdrawn_codes.h"

namespace tactus::store {
namespace {

using base::Result;
using Findings = std::vector<std::string>;

long long countRows(Connection& connection, const std::string& table) {
  Query query(connection, "SELECT count(*) FROM " + table);
  query.next();
  return query.integer();
}

void checkFile(Connection& connection, Findings& findings) {
  for (const char* check : {"integrity_check", "foreign_key_check"}) {
    const std::string finding = connection.firstFinding(check);
    if (!finding.empty()) findings.push_back(std::string(check) + ": " + finding);
  }
}

void checkChecksums(Connection& connection, Findings& findings) {
  for (const RecordTable& table : recordTables()) {
    const std::string name(table.name);
    Query query(connection, "SELECT " + std::string(keyOf(table).name) + " FROM " + name + " WHERE NOT " +
                                fitsChecksum(connection, name, name) + " ORDER BY 1");
    while (query.next()) findings.push_back(name + " " + study::toText(query.id()) + ": does not fit its CRC-32");
  }
}

std::vector<PastIncident> readIncidents(Connection& connection) {
  Query query(connection, "SELECT utc_ms, detail FROM incident ORDER BY utc_ms, id");
  std::vector<PastIncident> incidents;
  while (query.next()) {
    const std::int64_t utc_ms = query.integer();
    incidents.push_back({utc_ms, query.text()});
  }
  return incidents;
}

void checkIncidents(Connection& connection, Findings& findings) {
  for (const auto& incident : readIncidents(connection)) findings.push_back("incident: " + incident.sentence);
}

/// What is not finished, and what the opening for reading only said and could not note in the file.
void addNotices(const StudyFile& file, Findings& findings) {
  const std::string unfinished = unfinishedErasure(file.connection());
  if (!unfinished.empty()) findings.push_back("erasure: " + unfinished);
  if (file.access() != Access::kReadOnly) return;
  for (const auto& notice : file.notices()) findings.push_back("incident: " + notice.sentence);
}

void checkRecordings(Connection& connection, Findings& findings) {
  Query missing(connection, "SELECT id FROM stroke WHERE id NOT IN (SELECT stroke_id FROM recording)");
  while (missing.next()) findings.push_back("stroke " + study::toText(missing.id()) + ": has no recording");
  Query query(connection, "SELECT stroke_id, sample_rate_hz, samples, data FROM recording ORDER BY place");
  while (query.next()) {
    const std::string stroke = "recording of stroke " + study::toText(query.id());
    const double rate_hz = query.number();
    const auto samples = query.integer();
    const auto recording = decodeRecording(query.text());
    if (!recording) {
      findings.push_back(stroke + ": " + recording.error().found);
    } else if (recording->sample_rate_hz != rate_hz || static_cast<std::int64_t>(recording->size()) != samples) {
      findings.push_back(stroke + ": its columns and its data say different things");
    }
  }
}

void checkModels(Connection& connection, Findings& findings) {
  Query query(connection, "SELECT id, sha256, text FROM model_version ORDER BY place");
  while (query.next()) {
    const std::string version = "model version " + study::toText(query.id());
    const std::string hash = query.text();
    if (base::sha256(query.text()) != hash) findings.push_back(version + ": its text does not fit its SHA-256");
  }
}

}  // namespace

Result<StudyInfo> studyInfo(const StudyFile& file) {
  Connection& connection = file.connection();
  return guarded(connection, [&] {
    StudyInfo info;
    Query query(connection, "SELECT id, name, created_utc_ms, program FROM study");
    if (!query.next()) refuse(base::ErrorCode::kMismatch, {}, "a study without its first record", "an intact study");
    info.id = query.id();
    info.name = query.text();
    info.created_utc_ms = query.integer();
    info.program = query.text();
    info.version = connection.version();
    Query simulated(connection, "SELECT count(*) FROM person WHERE simulated = 1");
    simulated.next();
    info.simulated_persons = simulated.integer();
    const auto add = [&](std::string_view table) {
      info.counts.push_back({std::string(table), countRows(connection, std::string(table))});
    };
    for (const char* table : {"person", "session"}) add(table);
    for (const std::string_view table : kEntryTables) add(table);
    for (const char* table : {"model_version", "tombstone", "import_log"}) add(table);
    const auto felt = feelCounts(file);
    if (!felt) throw Refusal{felt.error()};
    info.placements = felt->placements;
    info.feel_recordings = felt->recordings;
    const auto protocol = protocolState(file);
    if (!protocol) throw Refusal{protocol.error()};
    if (protocol->current) info.protocol_version = protocol->current->version;
    info.protocol_locked = protocol->locked;
    return info;
  });
}

Result<std::vector<PastIncident>> pastIncidents(const StudyFile& file) {
  Connection& connection = file.connection();
  return guarded(connection, [&] { return readIncidents(connection); });
}

Result<std::vector<std::string>> checkStudy(const StudyFile& file) {
  Connection& connection = file.connection();
  return guarded(connection, [&] {
    Findings findings;
    checkFile(connection, findings);
    for (auto& conflict : conflicts(connection)) findings.push_back(std::move(conflict));
    checkChecksums(connection, findings);
    checkIncidents(connection, findings);
    addNotices(file, findings);
    checkRecordings(connection, findings);
    checkModels(connection, findings);
    auto felt = checkFeelRecords(file);
    if (!felt) throw Refusal{std::move(felt.error())};
    for (auto& finding : *felt) findings.push_back(std::move(finding));
    auto compared = checkDuelRecords(file);
    if (!compared) throw Refusal{std::move(compared.error())};
    for (auto& finding : *compared) findings.push_back(std::move(finding));
    auto sealed = checkSealedReferences(file);
    if (!sealed) throw Refusal{std::move(sealed.error())};
    for (auto& finding : *sealed) findings.push_back(std::move(finding));
    return findings;
  });
}

}  // namespace tactus::store
