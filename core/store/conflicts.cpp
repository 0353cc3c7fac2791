#include "core/store/conflicts.h"

#include "core/store/entries.h"
#include "core/store/person_codes.h"

namespace tactus::store {
namespace {

using Findings = std::vector<std::string>;

void checkOrder(Connection& connection, Findings& findings) {
  Query query(connection,
              "SELECT session_id, count(*), count(DISTINCT sequence), max(sequence) FROM session_record"
              " GROUP BY session_id HAVING count(*) <> max(sequence) OR count(DISTINCT sequence) <> count(*)");
  while (query.next()) {
    const std::string session = "session " + study::toText(query.id());
    const auto records = query.integer();
    const auto numbers = query.integer();
    const auto highest = query.integer();
    if (numbers < highest) {
      findings.push_back(session + ": " + std::to_string(highest - numbers) + " records are missing");
    }
    if (records > numbers) {
      findings.push_back(session + ": " + std::to_string(records - numbers) +
                         " records have the number of another, so it went on in two copies of the study");
    }
  }
}

void checkPersons(Connection& connection, Findings& findings) {
  for (const DoubledCode& doubled : doubledCodes(connection)) {
    findings.push_back("person: " + describe(doubled, "have") +
                       "; give one of them another: " + recodeCommand(connection, doubled));
  }
}

void checkCorrections(Connection& connection, Findings& findings) {
  for (const std::string_view table : kEntryTables) {
    Query query(connection, "SELECT supersedes, count(*) FROM " + std::string(table) +
                                " WHERE supersedes IS NOT NULL GROUP BY supersedes HAVING count(*) > 1");
    while (query.next()) {
      const std::string id = study::toText(query.id());
      findings.push_back(std::string(table) + " " + id + ": has " + std::to_string(query.integer()) +
                         " corrections, the latest counts");
    }
  }
}

/// Within one file a version that participants follow is not changed, so this is the work of two stations.
void checkProtocols(Connection& connection, Findings& findings) {
  Query query(connection,
              "SELECT p.version, count(DISTINCT p.id) FROM protocol AS p JOIN session AS s ON s.protocol_id = p.id"
              " JOIN person ON person.id = s.person_id WHERE person.simulated = 0"
              " GROUP BY p.version HAVING count(DISTINCT p.id) > 1 ORDER BY p.version");
  while (query.next()) {
    const std::string version = std::to_string(query.integer());
    findings.push_back("protocol: participants followed " + std::to_string(query.integer()) +
                       " protocols that are all version " + version + "; the latest counts from now on");
  }
}

}  // namespace

std::vector<std::string> circles(Connection& connection) {
  Findings findings;
  for (const std::string_view table : kEntryTables) {
    const std::string name(table);
    Query query(connection, "WITH RECURSIVE d(id) AS (SELECT id FROM " + name +
                                " WHERE supersedes IS NULL UNION SELECT c.id FROM d JOIN " + name +
                                " AS c ON c.supersedes = d.id) SELECT id FROM " + name +
                                " WHERE supersedes IS NOT NULL AND id NOT IN (SELECT id FROM d) ORDER BY id");
    while (query.next()) {
      findings.push_back(name + " " + study::toText(query.id()) +
                         ": its corrections go in a circle, so none of them counts");
    }
  }
  return findings;
}

std::vector<std::string> conflicts(Connection& connection) {
  Findings findings;
  checkOrder(connection, findings);
  checkPersons(connection, findings);
  checkCorrections(connection, findings);
  checkProtocols(connection, findings);
  for (auto& circle : circles(connection)) findings.push_back(std::move(circle));
  return findings;
}

}  // namespace tactus::store
