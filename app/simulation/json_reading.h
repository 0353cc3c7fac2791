// The members of one JSON object, read by name; what nobody asked for is refused.
#pragma once

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/error.h"

namespace tactus::simulation {

using Json = nlohmann::ordered_json;

struct Range {
  double low;
  double high;
};

/// The first error stays and silences everything after it, so that a reader asks for all members in a row and looks
/// once. A member that is absent leaves its target as it was.
class JsonMembers {
 public:
  /// Not an object is an error.
  JsonMembers(const Json& json, std::string place, std::optional<base::Error>& error);

  void number(std::string_view key, double& target, Range range);
  void number(std::string_view key, std::optional<double>& target, Range range);
  void integer(std::string_view key, int& target, Range range);
  void integer(std::string_view key, std::uint64_t& target);
  void flag(std::string_view key, bool& target);
  void flag(std::string_view key, std::optional<bool>& target);
  void text(std::string_view key, std::string& target);
  /// One of `words`; returns its index where the member is there.
  std::optional<std::size_t> word(std::string_view key, std::initializer_list<std::string_view> words);
  /// Numbers by name.
  template <class Map>
  void numbers(std::string_view key, Map& target, Range range);
  /// Object or array; null where it is absent.
  const Json* child(std::string_view key);
  /// Elements of the array `key` with their places.
  std::vector<std::pair<const Json*, std::string>> elements(std::string_view key);

  void require(std::string_view key);
  std::string placeOf(std::string_view key) const;
  void refuse(std::string_view key, std::string wanted);

  /// Refuses members that nobody asked for.
  void finish();

 private:
  const Json* find(std::string_view key);
  std::optional<double> numberIn(const Json& value, const std::string& place, Range range);

  const Json* json_ = nullptr;
  std::string place_;
  std::optional<base::Error>* error_;
  std::set<std::string, std::less<>> asked_;
};

template <class Map>
void JsonMembers::numbers(std::string_view key, Map& target, Range range) {
  const Json* const object = child(key);
  if (object == nullptr) return;
  if (!object->is_object()) return refuse(key, "an object of numbers");
  for (const auto& [name, value] : object->items())
    if (const auto found = numberIn(value, placeOf(key) + '/' + name, range)) target[name] = *found;
}

}  // namespace tactus::simulation
