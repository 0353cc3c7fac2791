#include "core/store/sessions.h"

#include <charconv>

#include "core/store/query.h"
#include "core/store/record_checksum.h"
#include "core/store/words.h"

namespace tactus::store {
namespace {

using base::Result;
using study::SessionRecord;

/// What readSession takes, of a session called `s`.
std::string sessionColumns(Connection& connection) {
  return "s.id, s.person_id, s.kind, s.started_utc_ms, s.started_monotonic_ns, s.consent_version, s.seed, s.language, "
         "s.station, s.program, s.device, s.device_friction_n, s.settings, s.protocol_id, " +
         fitsChecksum(connection, "session", "s");
}

std::uint64_t parseSeed(const std::string& text) {
  std::uint64_t seed = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, seed);
  if (stop != end || error != std::errc()) {
    refuse(base::ErrorCode::kValue, "session", base::quoted(text), "a seed of at most 64 bits");
  }
  return seed;
}

SessionRecord readSession(Query& query) {
  SessionRecord session;
  session.id = query.id();
  session.person = query.id();
  session.kind = fromWord<study::SessionKind>(query.text());
  session.started.utc_ms = query.integer();
  session.started.monotonic_ns = query.integer();
  session.consent_version = query.text();
  session.seed = parseSeed(query.text());
  session.language = query.text();
  session.station = query.text();
  session.program = query.text();
  session.device = query.text();
  session.device_friction_n = query.numberOrNothing();
  session.settings = query.text();
  session.protocol = query.idOrNothing();
  query.requireIntact("session", session.id);
  return session;
}

}  // namespace

Result<void> append(StudyFile& file, const SessionRecord& session) {
  Connection& connection = file.connection();
  return inTransaction(connection, [&] {
    Query insert(connection, insertion(connection, "session"));
    insert.put(session.id).put(session.person).put(wordFor(session.kind));
    insert.put(session.started.utc_ms).put(session.started.monotonic_ns).put(session.consent_version);
    insert.put(std::to_string(session.seed)).put(session.language).put(session.station).put(session.program);
    insert.put(session.device).put(session.device_friction_n).putJson(session.settings);
    insert.put(session.protocol).run();
  });
}

Result<std::vector<SessionRecord>> sessions(const StudyFile& file, const std::optional<study::RecordId>& person) {
  Connection& connection = file.connection();
  return guarded(connection, [&] {
    Query query(connection, "SELECT " + sessionColumns(connection) + " FROM session AS s" +
                                (person ? " WHERE s.person_id = ?" : "") + " ORDER BY s.started_utc_ms, s.id");
    if (person) query.put(*person);
    std::vector<SessionRecord> found;
    while (query.next()) found.push_back(readSession(query));
    return found;
  });
}

Result<std::vector<SessionSummary>> sessionList(const StudyFile& file) {
  Connection& connection = file.connection();
  return guarded(connection, [&] {
    Query query(connection, "SELECT " + sessionColumns(connection) +
                                ", p.code, p.simulated,"
                                " (SELECT count(*) FROM stroke WHERE session_id = s.id),"
                                " (SELECT count(*) FROM judgement WHERE session_id = s.id),"
                                " (SELECT count(*) FROM answer WHERE session_id = s.id)"
                                " FROM session AS s JOIN person_current AS p ON p.id = s.person_id"
                                " ORDER BY s.started_utc_ms, s.id");
    std::vector<SessionSummary> found;
    while (query.next()) {
      SessionSummary summary;
      summary.session = readSession(query);
      summary.code = query.text();
      summary.simulated = query.flag();
      summary.strokes = query.integer();
      summary.judgements = query.integer();
      summary.answers = query.integer();
      found.push_back(std::move(summary));
    }
    return found;
  });
}

}  // namespace tactus::store
