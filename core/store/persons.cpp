#include "core/store/persons.h"

#include "core/store/query.h"

namespace tactus::store {
namespace {

using base::ErrorCode;
using base::Result;
using study::Person;

std::vector<Person> readPersons(Query& query) {
  std::vector<Person> found;
  while (query.next()) {
    Person person;
    person.id = query.id();
    person.code = query.text();
    person.simulated = query.flag();
    found.push_back(std::move(person));
  }
  return found;
}

bool isTaken(Connection& connection, const std::string& code) {
  Query query(connection, "SELECT 1 FROM person WHERE code = ?");
  return query.put(code).next();
}

}  // namespace

Result<void> append(StudyFile& file, const Person& person) {
  Connection& connection = file.connection();
  return inTransaction(connection, [&] {
    if (isTaken(connection, person.code)) {
      refuse(ErrorCode::kValue, {}, "the code " + base::quoted(person.code) + ", which a person of the study has",
             "a code of its own for each person");
    }
    Query insert(connection, "INSERT INTO person (id, code, simulated) VALUES (?, ?, ?)");
    insert.put(person.id).put(person.code).put(person.simulated).run();
  });
}

Result<std::string> unusedCode(const StudyFile& file, PersonCodes& codes) {
  constexpr int kMostDraws = 1000;  // fails only where nearly all 40,000 codes are in use
  Connection& connection = file.connection();
  return guarded(connection, [&] {
    for (int draw = 0; draw < kMostDraws; ++draw) {
      std::string code = codes.next();
      if (!isTaken(connection, code)) return code;
    }
    refuse(ErrorCode::kLimit, {}, "a study in which nearly all codes are in use", "fewer persons");
  });
}

Result<std::vector<Person>> persons(const StudyFile& file) {
  Connection& connection = file.connection();
  return guarded(connection, [&] {
    Query query(connection, "SELECT id, code, simulated FROM person ORDER BY code, id");
    return readPersons(query);
  });
}

Result<std::optional<Person>> findPerson(const StudyFile& file, const std::string& code) {
  Connection& connection = file.connection();
  return guarded(connection, [&]() -> std::optional<Person> {
    Query query(connection, "SELECT id, code, simulated FROM person WHERE code = ? ORDER BY id");
    const auto found = readPersons(query.put(code));
    if (found.size() > 1) {
      refuse(ErrorCode::kReference, {}, std::to_string(found.size()) + " persons with the code " + base::quoted(code),
             "one; name the person by id");
    }
    if (found.empty()) return std::nullopt;
    return found.front();
  });
}

}  // namespace tactus::store
