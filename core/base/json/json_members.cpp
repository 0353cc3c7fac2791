#include "core/base/json/json_members.h"

#include <charconv>
#include <cmath>

#include "core/base/text.h"

namespace tactus::base {

JsonMembers::JsonMembers(JsonValue value, std::optional<Error>& error) : error_(error) {
  if (value.kind() == JsonKind::kObject) {
    object_ = value;
  } else {
    refuse(value, ErrorCode::kSchema, "an object");
  }
}

std::optional<JsonValue> JsonMembers::find(std::string_view key) {
  asked_.emplace(key);
  if (error_ || !object_) return std::nullopt;
  return object_->find(key);
}

void JsonMembers::refuse(const JsonValue& value, ErrorCode code, std::string wanted) {
  if (!error_) error_ = Error{code, {}, value.pointer(), value.description(), std::move(wanted)};
}

void JsonMembers::refuse(std::string_view key, std::string wanted) {
  if (error_ || !object_) return;
  if (const auto value = object_->find(key)) return refuse(*value, ErrorCode::kValue, std::move(wanted));
  error_ = Error{ErrorCode::kSchema, {}, object_->pointer(), "no member " + base::quoted(key), std::move(wanted)};
}

std::optional<double> JsonMembers::numberIn(const JsonValue& value, NumberRange range) {
  if (error_) return std::nullopt;
  if (value.kind() == JsonKind::kNumber && value.number() >= range.low && value.number() <= range.high)
    return value.number();
  refuse(value, ErrorCode::kValue, "a number in [" + formatNumber(range.low) + ", " + formatNumber(range.high) + "]");
  return std::nullopt;
}

void JsonMembers::number(std::string_view key, double& target, NumberRange range) {
  if (const auto value = find(key))
    if (const auto found = numberIn(*value, range)) target = *found;
}

void JsonMembers::number(std::string_view key, std::optional<double>& target, NumberRange range) {
  if (const auto value = find(key))
    if (const auto found = numberIn(*value, range)) target = *found;
}

void JsonMembers::integer(std::string_view key, int& target, NumberRange range) {
  const auto value = find(key);
  if (!value) return;
  const auto found = numberIn(*value, range);
  if (!found) return;
  if (*found != std::floor(*found)) return refuse(*value, ErrorCode::kValue, "a whole number");
  target = static_cast<int>(*found);
}

void JsonMembers::integer(std::string_view key, std::uint64_t& target) {
  const auto value = find(key);
  if (!value) return;
  const std::string_view digits = value->text();
  std::uint64_t found = 0;
  const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), found);
  if (value->kind() != JsonKind::kNumber || problem != std::errc{} || end != digits.data() + digits.size())
    return refuse(*value, ErrorCode::kValue, "a whole number from 0 to 18446744073709551615");
  target = found;
}

void JsonMembers::flag(std::string_view key, bool& target) {
  std::optional<bool> found;
  flag(key, found);
  target = found.value_or(target);
}

void JsonMembers::flag(std::string_view key, std::optional<bool>& target) {
  const auto value = find(key);
  if (!value) return;
  if (value->kind() != JsonKind::kTrue && value->kind() != JsonKind::kFalse)
    return refuse(*value, ErrorCode::kSchema, "true or false");
  target = value->kind() == JsonKind::kTrue;
}

void JsonMembers::text(std::string_view key, std::string& target) {
  const auto value = find(key);
  if (!value) return;
  if (value->kind() != JsonKind::kString || value->text().empty())
    return refuse(*value, ErrorCode::kSchema, "a text that is not empty");
  target = value->text();
}

std::optional<std::size_t> JsonMembers::word(std::string_view key, std::span<const std::string_view> words) {
  const auto value = find(key);
  if (!value) return std::nullopt;
  for (std::size_t i = 0; i < words.size(); ++i)
    if (value->kind() == JsonKind::kString && value->text() == words[i]) return i;
  refuse(*value, ErrorCode::kValue, "one of " + joined(words, ", "));
  return std::nullopt;
}

void JsonMembers::numbers(std::string_view key, std::map<std::string, double>& target, NumberRange range) {
  const auto object = find(key);
  if (!object) return;
  if (object->kind() != JsonKind::kObject) return refuse(*object, ErrorCode::kSchema, "an object of numbers");
  for (const JsonValue value : *object)
    if (const auto found = numberIn(value, range)) target[std::string(value.key())] = *found;
}

std::optional<JsonValue> JsonMembers::child(std::string_view key) { return find(key); }

std::vector<JsonValue> JsonMembers::elements(std::string_view key) {
  std::vector<JsonValue> all;
  const auto list = find(key);
  if (!list) return all;
  if (list->kind() != JsonKind::kArray) {
    refuse(*list, ErrorCode::kSchema, "an array");
    return all;
  }
  for (const JsonValue value : *list) all.push_back(value);
  return all;
}

void JsonMembers::require(std::string_view key) {
  if (!find(key)) refuse(key, "the member " + base::quoted(key));
}

bool JsonMembers::has(std::string_view key) const { return object_ && object_->find(key); }

void JsonMembers::finish() {
  if (error_ || !object_) return;
  for (const JsonValue member : *object_) {
    if (asked_.contains(member.key())) continue;
    error_ = Error{ErrorCode::kSchema,
                   {},
                   member.pointer(),
                   "the member " + base::quoted(member.key()),
                   "one of " + joined(asked_, ", ")};
    return;
  }
}

}  // namespace tactus::base
