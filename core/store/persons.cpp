#include "core/store/persons.h"

#include <set>

#include "core/base/tables/csv.h"
#include "core/store/person_codes.h"
#include "core/store/query.h"
#include "core/store/record_checksum.h"
#include "core/store/withdrawn_codes.h"
#include "core/study/record_id.h"

namespace tactus::store {
namespace {

using base::ErrorCode;
using base::Result;
using study::Person;

/// What readPersons takes, with the code that counts.
std::string selection(Connection& connection) {
  return "SELECT p.id, c.code, p.simulated, " + fitsChecksum(connection, "person", "p") +
         " FROM person AS p JOIN person_current AS c ON c.id = p.id";
}

std::vector<Person> readPersons(Query& query) {
  std::vector<Person> found;
  while (query.next()) {
    Person person;
    person.id = query.id();
    person.code = query.text();
    person.simulated = query.flag();
    query.requireIntact("person", person.id);
    found.push_back(std::move(person));
  }
  return found;
}

bool isTaken(Connection& connection, const std::string& code) {
  Query query(connection, "SELECT 1 FROM person_current WHERE code = ?");
  return query.put(code).next();
}

/// Of all codes that persons have or had: one that was changed stays the earlier person's in models and exports.
std::set<std::string> takenKeys(Connection& connection) {
  Query query(connection, "SELECT code FROM person UNION SELECT code FROM person_code");
  std::set<std::string> keys;
  while (query.next()) keys.insert(study::codeKey(query.text()));
  return keys;
}

}  // namespace

Result<void> append(StudyFile& file, const Person& person) {
  Connection& connection = file.connection();
  return inTransaction(connection, [&] {
    if (base::looksLikeFormula(person.code)) {
      refuse(ErrorCode::kValue, {}, "the code " + base::quoted(person.code), base::kNoFormula);
    }
    if (isTaken(connection, person.code)) {
      refuse(ErrorCode::kValue, {}, "the code " + base::quoted(person.code) + ", which a person of the study has",
             "a code of its own for each person");
    }
    refuseWithdrawnCode(connection, person.code);
    Query insert(connection, insertion(connection, "person"));
    insert.put(person.id).put(person.code).put(person.simulated).run();
  });
}

Result<std::string> unusedCode(const StudyFile& file, PersonCodes& codes) {
  constexpr int kMostDraws = 1000;  // fails only where nearly all 40,000 codes are in use
  Connection& connection = file.connection();
  return guarded(connection, [&] {
    const auto withdrawn = readTombstones(connection);
    const auto taken = takenKeys(connection);
    for (int draw = 0; draw < kMostDraws; ++draw) {
      std::string code = codes.next();
      if (!taken.contains(study::codeKey(code)) && withdrawnWith(withdrawn, code) == nullptr) return code;
    }
    refuse(ErrorCode::kLimit, {}, "a study in which nearly all codes are in use", "fewer persons");
  });
}

Result<std::vector<Person>> persons(const StudyFile& file) {
  Connection& connection = file.connection();
  return guarded(connection, [&] {
    Query query(connection, selection(connection) + " ORDER BY c.code, p.id");
    return readPersons(query);
  });
}

Result<std::optional<Person>> findPerson(const StudyFile& file, const std::string& code) {
  Connection& connection = file.connection();
  return guarded(connection, [&]() -> std::optional<Person> {
    Query query(connection, selection(connection) + " WHERE c.code = ? ORDER BY p.id");
    const auto found = readPersons(query.put(code));
    if (found.size() > 1) {
      DoubledCode doubled{code, {}};
      for (const auto& person : found) doubled.persons.push_back(person.id);
      refuse(ErrorCode::kReference, {}, describe(doubled),
             "a code of its own for each person: " + recodeCommand(connection, doubled));
    }
    if (found.empty()) return std::nullopt;
    return found.front();
  });
}

}  // namespace tactus::store
