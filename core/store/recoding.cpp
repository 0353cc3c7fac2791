#include "core/store/recoding.h"

#include <algorithm>

#include "core/base/tables/csv.h"
#include "core/store/persons.h"
#include "core/store/query.h"
#include "core/store/record_checksum.h"
#include "core/store/withdrawn_codes.h"

namespace tactus::store {
namespace {

using base::ErrorCode;
using base::Result;
using study::RecordId;

bool wasEverUsed(Connection& connection, const std::string& code) {
  Query query(connection, "SELECT 1 FROM person WHERE code = ?1 UNION ALL SELECT 1 FROM person_code WHERE code = ?1");
  return query.put(code).next();
}

std::string freeCodeLike(Connection& connection, const std::string& code) {
  const auto withdrawn = readTombstones(connection);
  for (int number = 2;; ++number) {
    std::string candidate = code + '-' + std::to_string(number);
    if (!wasEverUsed(connection, candidate) && withdrawnWith(withdrawn, candidate) == nullptr) return candidate;
  }
}

std::vector<study::Person> choose(const std::vector<study::Person>& all, const std::string& name) {
  std::vector<study::Person> chosen;
  std::copy_if(all.begin(), all.end(), std::back_inserter(chosen),
               [&](const study::Person& person) { return person.code == name; });
  const auto id = study::parseRecordId(name);
  if (!chosen.empty() || !id) return chosen;
  std::copy_if(all.begin(), all.end(), std::back_inserter(chosen),
               [&](const study::Person& person) { return person.id == *id; });
  return chosen;
}

}  // namespace

Result<void> recode(StudyFile& file, const RecordId& person, const std::string& code, const RecordId& change,
                    std::int64_t utc_ms) {
  Connection& connection = file.connection();
  return inTransaction(connection, [&] {
    if (codesOf(connection, person).empty()) {
      refuse(ErrorCode::kReference, {}, "no person " + study::toText(person), "a person of the study");
    }
    if (code.empty()) refuse(ErrorCode::kValue, {}, "an empty code", "a code");
    if (base::looksLikeFormula(code)) refuse(ErrorCode::kValue, {}, "the code " + base::quoted(code), base::kNoFormula);
    if (wasEverUsed(connection, code)) {
      refuse(ErrorCode::kValue, {}, "the code " + base::quoted(code) + ", which a person of the study has or had",
             "one that no person had yet, such as " + base::quoted(freeCodeLike(connection, code)));
    }
    refuseWithdrawnCode(connection, code);
    Query insert(connection, insertion(connection, "person_code"));
    insert.put(change).put(person).put(utc_ms).put(code).run();
  });
}

Result<study::Person> personNamed(const StudyFile& file, const std::string& name) {
  const auto all = persons(file);
  if (!all) return tl::unexpected(all.error());
  const auto chosen = choose(*all, name);
  if (chosen.size() == 1) return chosen.front();
  Connection& connection = file.connection();
  return guarded(connection, [&]() -> study::Person {
    if (chosen.size() > 1) {
      DoubledCode doubled{name, {}};
      for (const auto& person : chosen) doubled.persons.push_back(person.id);
      refuse(ErrorCode::kReference, {}, describe(doubled), "one of the ids");
    }
    const auto withdrawn = readTombstones(connection);
    if (const auto* row = withdrawnWith(withdrawn, name); row != nullptr) {
      refuse(ErrorCode::kReference, {}, describeWithdrawn(name, *row), "a participant of the study");
    }
    refuse(ErrorCode::kReference, {}, "no participant " + base::quoted(name), "a participant's code or id");
  });
}

Result<void> requireDistinctCodes(const StudyFile& file) {
  Connection& connection = file.connection();
  return guarded(connection, [&] {
    const auto doubled = doubledCodes(connection);
    if (doubled.empty()) return;
    refuse(ErrorCode::kData, {}, describe(doubled.front()),
           "a code of its own for each person: " + recodeCommand(connection, doubled.front()));
  });
}

std::vector<DoubledCode> doubledCodes(Connection& connection) {
  Query query(connection,
              "SELECT code, id FROM person_current WHERE code IN"
              " (SELECT code FROM person_current GROUP BY code HAVING count(*) > 1) ORDER BY code, id");
  std::vector<DoubledCode> found;
  while (query.next()) {
    std::string code = query.text();
    if (found.empty() || found.back().code != code) found.push_back({std::move(code), {}});
    found.back().persons.push_back(query.id());
  }
  return found;
}

std::string describe(const DoubledCode& doubled, std::string_view verb) {
  std::string ids;
  for (const auto& id : doubled.persons) ids += (ids.empty() ? "" : ", ") + study::toText(id);
  return std::to_string(doubled.persons.size()) + " persons " + std::string(verb) + " the code " +
         base::quoted(doubled.code) + " (ids " + ids + ")";
}

std::string recodeCommand(Connection& connection, const DoubledCode& doubled) {
  return "tactus study recode " + shellWord(connection.path()) + ' ' + study::toText(doubled.persons.back()) + ' ' +
         shellWord(freeCodeLike(connection, doubled.code));
}

std::string shellWord(std::string_view text) {
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("_-./+:@%").find(c) != std::string_view::npos;
  };
  if (!text.empty() && std::all_of(text.begin(), text.end(), is_plain)) return std::string(text);
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return base::oneLine(word + '\'');
}

}  // namespace tactus::store
