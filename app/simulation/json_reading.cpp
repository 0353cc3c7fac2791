#include "app/simulation/json_reading.h"

#include "core/base/json_pointer.h"
#include "core/base/text.h"

namespace tactus::simulation {

JsonMembers::JsonMembers(const Json& json, std::string place, std::optional<base::Error>& error)
    : place_(std::move(place)), error_(&error) {
  if (json.is_object()) {
    json_ = &json;
  } else if (!error) {
    error = base::Error{base::ErrorCode::kSchema, {}, place_, base::quoted(json.dump()), "an object"};
  }
}

std::string JsonMembers::placeOf(std::string_view key) const { return base::childPointer(place_, key); }

const Json* JsonMembers::find(std::string_view key) {
  asked_.emplace(key);
  if (*error_ || json_ == nullptr) return nullptr;
  const auto it = json_->find(key);
  return it == json_->end() ? nullptr : &*it;
}

void JsonMembers::refuse(std::string_view key, std::string wanted) {
  if (*error_ || json_ == nullptr) return;
  const auto it = json_->find(key);
  const bool there = it != json_->end();
  *error_ = base::Error{there ? base::ErrorCode::kValue : base::ErrorCode::kSchema,
                        {},
                        there ? placeOf(key) : place_,
                        there ? base::quoted(it->dump()) : "no member " + base::quoted(key),
                        std::move(wanted)};
}

std::optional<double> JsonMembers::numberIn(const Json& value, const std::string& place, Range range) {
  if (*error_) return std::nullopt;
  const double number = value.is_number() ? value.get<double>() : range.low - 1;
  if (value.is_number() && number >= range.low && number <= range.high) return number;
  *error_ = base::Error{base::ErrorCode::kValue,
                        {},
                        place,
                        base::quoted(value.dump()),
                        "a number in [" + base::formatNumber(range.low) + ", " + base::formatNumber(range.high) + "]"};
  return std::nullopt;
}

void JsonMembers::number(std::string_view key, double& target, Range range) {
  if (const Json* const value = find(key))
    if (const auto found = numberIn(*value, placeOf(key), range)) target = *found;
}

void JsonMembers::number(std::string_view key, std::optional<double>& target, Range range) {
  if (const Json* const value = find(key))
    if (const auto found = numberIn(*value, placeOf(key), range)) target = *found;
}

void JsonMembers::integer(std::string_view key, int& target, Range range) {
  const Json* const value = find(key);
  if (value == nullptr) return;
  if (!value->is_number_integer()) return refuse(key, "a whole number");
  if (const auto found = numberIn(*value, placeOf(key), range)) target = static_cast<int>(*found);
}

void JsonMembers::integer(std::string_view key, std::uint64_t& target) {
  const Json* const value = find(key);
  if (value == nullptr) return;
  if (!value->is_number_unsigned()) return refuse(key, "a whole number from 0");
  target = value->get<std::uint64_t>();
}

void JsonMembers::flag(std::string_view key, bool& target) {
  std::optional<bool> found;
  flag(key, found);
  target = found.value_or(target);
}

void JsonMembers::flag(std::string_view key, std::optional<bool>& target) {
  const Json* const value = find(key);
  if (value == nullptr) return;
  if (!value->is_boolean()) return refuse(key, "true or false");
  target = value->get<bool>();
}

void JsonMembers::text(std::string_view key, std::string& target) {
  const Json* const value = find(key);
  if (value == nullptr) return;
  if (!value->is_string() || value->get_ref<const std::string&>().empty()) return refuse(key, "a text");
  target = value->get<std::string>();
}

std::optional<std::size_t> JsonMembers::word(std::string_view key, std::initializer_list<std::string_view> words) {
  const Json* const value = find(key);
  if (value == nullptr) return std::nullopt;
  std::size_t index = 0;
  for (const std::string_view known : words) {
    if (value->is_string() && value->get_ref<const std::string&>() == known) return index;
    ++index;
  }
  refuse(key, "one of " + base::joined(words, ", "));
  return std::nullopt;
}

const Json* JsonMembers::child(std::string_view key) { return find(key); }

std::vector<std::pair<const Json*, std::string>> JsonMembers::elements(std::string_view key) {
  std::vector<std::pair<const Json*, std::string>> all;
  const Json* const list = find(key);
  if (list == nullptr) return all;
  if (!list->is_array()) {
    refuse(key, "a list");
    return all;
  }
  for (std::size_t i = 0; i < list->size(); ++i) all.emplace_back(&(*list)[i], base::childPointer(placeOf(key), i));
  return all;
}

void JsonMembers::require(std::string_view key) {
  if (find(key) == nullptr) refuse(key, "the member " + base::quoted(key));
}

void JsonMembers::finish() {
  if (*error_ || json_ == nullptr) return;
  for (const auto& [key, value] : json_->items()) {
    if (asked_.contains(key)) continue;
    *error_ = base::Error{base::ErrorCode::kSchema,
                          {},
                          placeOf(key),
                          "the member " + base::quoted(key),
                          "one of " + base::joined(asked_, ", ")};
    return;
  }
}

}  // namespace tactus::simulation
