#include "core/store/typed_code.h"

#include <algorithm>

#include "core/base/close_match.h"
#include "core/store/persons.h"
#include "core/study/record_id.h"

namespace tactus::store {
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
  auto all = persons(file);
  if (!all) return tl::unexpected(all.error());
  const std::string key = study::codeKey(typed);
  TypedCode found;
  if (key.empty()) return found;
  std::vector<study::Person> same;
  std::vector<study::Person> exact;
  for (const auto& person : *all) {
    if (study::codeKey(person.code) == key) same.push_back(person);
    if (person.code == typed) exact.push_back(person);
  }
  if (exact.size() == 1) {
    found.person = exact.front();
  } else if (same.size() == 1) {
    found.person = same.front();
  } else {
    found.meant = closeCodes(*all, key);
  }
  return found;
}

}  // namespace tactus::store
