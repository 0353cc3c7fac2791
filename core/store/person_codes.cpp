#include "core/store/person_codes.h"

#include <algorithm>

#include "core/base/check.h"
#include "core/base/error.h"
#include "core/base/tables/csv.h"
#include "core/base/text.h"
#include "core/store/persons.h"
#include "core/store/query.h"
#include "core/store/record_checksum.h"
#include "core/store/withdrawn_codes.h"
#include "core/study/record_id.h"

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
  TACTUS_TRY(const auto all, persons(file));
  const auto chosen = choose(all, name);
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

namespace {

constexpr std::size_t kMostMeant = 3;

/// The codes of `persons` that are close to the typed one; codes with the same key are the closest.
std::vector<std::string> closeCodes(const std::vector<study::Person>& persons, const std::string& key) {
  struct Known {
    std::string key;
    std::string code;
  };
  std::vector<Known> left;
  for (const auto& person : persons) left.push_back({study::codeKey(person.code), person.code});
  std::vector<std::string> close;
  while (close.size() < kMostMeant) {
    std::vector<std::string> keys;
    for (const auto& known : left) keys.push_back(known.key);
    const std::string closest = base::closestWord(key, keys);
    if (closest.empty()) break;
    const auto found = std::find_if(left.begin(), left.end(), [&](const Known& known) { return known.key == closest; });
    close.push_back(found->code);
    left.erase(found);
  }
  return close;
}

}  // namespace

base::Result<TypedCode> findTyped(const StudyFile& file, const std::string& typed) {
  TACTUS_TRY(auto all, persons(file));
  const std::string key = study::codeKey(typed);
  TypedCode found;
  if (key.empty()) return found;
  std::vector<study::Person> same;
  std::vector<study::Person> exact;
  for (const auto& person : all) {
    if (study::codeKey(person.code) == key) same.push_back(person);
    if (person.code == typed) exact.push_back(person);
  }
  if (exact.size() == 1) {
    found.person = exact.front();
  } else if (same.size() == 1) {
    found.person = same.front();
  } else {
    found.meant = closeCodes(all, key);
  }
  return found;
}

// Embedded from core/store/data.
std::string_view codeWords();

namespace {

std::uint64_t seedFromEntropy() {
  std::random_device device;
  return (static_cast<std::uint64_t>(device()) << 32U) | device();
}

/// The words of the block that begins with the line `title`.
std::vector<std::string_view> wordsUnder(std::string_view title) {
  std::vector<std::string_view> words;
  std::string_view rest = codeWords();
  rest.remove_prefix(rest.find(title) + title.size() + 1);
  rest = rest.substr(0, rest.find('['));
  while (!rest.empty()) {
    const auto end = rest.find_first_of(" \n");
    if (end > 0) words.push_back(rest.substr(0, end));
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  }
  return words;
}

}  // namespace

PersonCodes::PersonCodes() : PersonCodes(seedFromEntropy()) {}

PersonCodes::PersonCodes(std::uint64_t seed)
    : first_(wordsUnder("[first]")), second_(wordsUnder("[second]")), engine_(seed) {
  TACTUS_CHECK(!first_.empty() && !second_.empty());
}

std::string_view PersonCodes::draw(const std::vector<std::string_view>& words) {
  // 64 random bits against a few hundred words: the rest of the division favors no word by more than 1e-16.
  return words[static_cast<std::size_t>(engine_() % words.size())];
}

std::string PersonCodes::next() {
  std::string code(draw(first_));
  code += '-';
  code += draw(second_);
  return code;
}

}  // namespace tactus::store
