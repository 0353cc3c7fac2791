#include "core/base/json/json_members.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/base/json/json_document.h"
#include "core/base/text.h"

namespace tactus::base {
namespace {

constexpr std::string_view kNotEmpty = "a text that is not empty";
constexpr std::string_view kTrueOrFalse = "true or false";

std::string_view inWords(JsonKind kind) {
  switch (kind) {
    case JsonKind::kNumber: return "a number";
    case JsonKind::kString: return "a string";
    case JsonKind::kArray: return "an array";
    default: return "an object";
  }
}

std::string inWords(NumberRange range) {
  if (range.low == kAnyNumber.low && range.high == kAnyNumber.high) return std::string(inWords(JsonKind::kNumber));
  return "a number in [" + formatNumber(range.low) + ", " + formatNumber(range.high) + "]";
}

/// `'a', 'b' or 'c'`.
std::string oneOf(std::span<const std::string_view> words) {
  std::string list;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) list += i + 1 == words.size() ? " or " : ", ";
    list += base::quoted(words[i]);
  }
  return list;
}

}  // namespace

JsonMembers::JsonMembers(JsonValue value, std::optional<Error>& error) : error_(error) {
  if (isOf(JsonKind::kObject, value)) object_ = value;
}

template <class Wanted>
std::optional<JsonValue> JsonMembers::find(JsonKey key, Wanted wanted) {
  asked_.push_back(key.name);
  if (error_ || !object_) return std::nullopt;
  const auto value = object_->find(key.name);
  if (!value && key.required) {
    error_ = Error{ErrorCode::kSchema,
                   {},
                   object_->pointer(),
                   "no key " + base::quoted(key.name),
                   "a key " + base::quoted(key.name) + " with " + std::string(wanted())};
  }
  return value;
}

std::optional<JsonValue> JsonMembers::findOf(JsonKind kind, JsonKey key) {
  const auto value = find(key, [kind] { return inWords(kind); });
  return value && isOf(kind, *value) ? value : std::nullopt;
}

bool JsonMembers::isOf(JsonKind kind, JsonValue value) {
  if (value.kind() == kind) return true;
  refuse(value, ErrorCode::kSchema, std::string(inWords(kind)));
  return false;
}

bool JsonMembers::isNotEmpty(JsonValue value) {
  if (value.kind() == JsonKind::kString && !value.text().empty()) return true;
  refuse(value, ErrorCode::kSchema, std::string(kNotEmpty));
  return false;
}

void JsonMembers::refuse(JsonValue value, ErrorCode code, std::string wanted) {
  if (!error_) error_ = Error{code, {}, value.pointer(), value.description(), std::move(wanted)};
}

void JsonMembers::refuse(std::string_view key, std::string wanted) {
  const auto value = object_ ? object_->find(key) : std::nullopt;
  refuse(key, value ? value->description() : "nothing", std::move(wanted));
}

void JsonMembers::refuse(std::string_view key, std::string found, std::string wanted, ErrorCode code) {
  if (error_ || !object_) return;
  error_ = Error{code, {}, childPointer(object_->pointer(), key), std::move(found), std::move(wanted)};
}

void JsonMembers::refuse(std::string_view key, Error inside) {
  if (error_ || !object_) return;
  const std::string place = childPointer(object_->pointer(), key);
  inside.place = inside.place.empty() ? place : place + ": " + inside.place;
  error_ = std::move(inside);
}

void JsonMembers::format(std::string_view name) { word(required("format"), {&name, 1}); }

void JsonMembers::version(JsonKey key) {
  double version = 1;
  number(key, version);
  if (version == 1) return;
  const bool newer = version > 1;
  refuse(key.name, "version " + formatNumber(version) + (newer ? ", newer than this program" : ""),
         newer ? "at most version 1" : "version 1", newer ? ErrorCode::kVersion : ErrorCode::kValue);
}

std::optional<double> JsonMembers::numberIn(JsonValue value, NumberRange range) {
  if (value.kind() != JsonKind::kNumber) {
    refuse(value, ErrorCode::kSchema, inWords(range));
  } else if (value.number() < range.low || value.number() > range.high) {
    refuse(value, ErrorCode::kValue, inWords(range));
  } else {
    return value.number();
  }
  return std::nullopt;
}

void JsonMembers::number(JsonKey key, double& target, NumberRange range) {
  std::optional<double> found;
  number(key, found, range);
  target = found.value_or(target);
}

void JsonMembers::number(JsonKey key, std::optional<double>& target, NumberRange range) {
  if (const auto value = find(key, [range] { return inWords(range); }))
    if (const auto found = numberIn(*value, range)) target = found;
}

void JsonMembers::numberOrNull(JsonKey key, std::optional<double>& target) {
  const auto value = find(key, [] { return "a number or null"; });
  if (!value) return;
  if (value->kind() == JsonKind::kNull) return target.reset();
  if (value->kind() != JsonKind::kNumber) return refuse(*value, ErrorCode::kSchema, "a number or null");
  target = value->number();
}

void JsonMembers::integer(JsonKey key, int& target, NumberRange range) {
  const auto wanted = [range] {
    const auto low = static_cast<int>(range.low), high = static_cast<int>(range.high);
    return "a whole number from " + std::to_string(low) + " to " + std::to_string(high);
  };
  const auto value = find(key, wanted);
  if (!value) return;
  const bool is_number = value->kind() == JsonKind::kNumber;
  const double found = is_number ? value->number() : 0;
  if (!is_number) return refuse(*value, ErrorCode::kSchema, wanted());
  if (found < range.low || found > range.high || found != std::floor(found))
    return refuse(*value, ErrorCode::kValue, wanted());
  target = static_cast<int>(found);
}

template <class Integer>
void JsonMembers::wholeNumber(JsonKey key, Integer& target) {
  using Limits = std::numeric_limits<Integer>;
  const auto wanted = [] {
    return "a whole number from " + std::to_string(Limits::min()) + " to " + std::to_string(Limits::max());
  };
  const auto value = find(key, wanted);
  if (!value) return;
  const std::string_view digits = value->text();
  Integer found = 0;
  const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), found);
  if (value->kind() != JsonKind::kNumber || problem != std::errc{} || end != digits.data() + digits.size())
    return refuse(*value, ErrorCode::kValue, wanted());
  target = found;
}

void JsonMembers::integer(JsonKey key, std::int64_t& target) { wholeNumber(key, target); }
void JsonMembers::integer(JsonKey key, std::uint64_t& target) { wholeNumber(key, target); }

void JsonMembers::flag(JsonKey key, bool& target) {
  std::optional<bool> found;
  flag(key, found);
  target = found.value_or(target);
}

void JsonMembers::flag(JsonKey key, std::optional<bool>& target) {
  const auto value = find(key, [] { return kTrueOrFalse; });
  if (!value) return;
  if (value->kind() != JsonKind::kTrue && value->kind() != JsonKind::kFalse)
    return refuse(*value, ErrorCode::kSchema, std::string(kTrueOrFalse));
  target = value->kind() == JsonKind::kTrue;
}

void JsonMembers::text(JsonKey key, std::string& target) {
  const auto value = find(key, [] { return kNotEmpty; });
  if (value && isNotEmpty(*value)) target = value->text();
}

void JsonMembers::textOrEmpty(JsonKey key, std::string& target) {
  if (const auto value = findOf(JsonKind::kString, key)) target = value->text();
}

std::optional<std::size_t> JsonMembers::word(JsonKey key, std::span<const std::string_view> words) {
  const auto value = find(key, [words] { return oneOf(words); });
  if (!value) return std::nullopt;
  const bool is_text = value->kind() == JsonKind::kString;
  const auto at = std::find(words.begin(), words.end(), value->text());
  if (is_text && at != words.end()) return static_cast<std::size_t>(at - words.begin());
  refuse(*value, is_text ? ErrorCode::kValue : ErrorCode::kSchema, oneOf(words));
  return std::nullopt;
}

void JsonMembers::numbers(JsonKey key, std::map<std::string, double>& target, NumberRange range) {
  const auto object = findOf(JsonKind::kObject, key);
  if (!object) return;
  for (const JsonValue value : *object)
    if (const auto found = numberIn(value, range)) target[std::string(value.key())] = *found;
}

void JsonMembers::numbers(JsonKey key, std::vector<double>& target) {
  const auto list = findOf(JsonKind::kArray, key);
  if (!list) return;
  target.clear();
  for (const JsonValue value : *list)
    if (isOf(JsonKind::kNumber, value)) target.push_back(value.number());
}

void JsonMembers::texts(JsonKey key, std::vector<std::string>& target) {
  const auto list = findOf(JsonKind::kArray, key);
  if (!list) return;
  target.clear();
  for (const JsonValue value : *list)
    if (isOf(JsonKind::kString, value)) target.emplace_back(value.text());
}

void JsonMembers::texts(JsonKey key, std::vector<NamedText>& target) {
  const auto object = findOf(JsonKind::kObject, key);
  if (!object) return;
  target.clear();
  for (const JsonValue value : *object)
    if (isNotEmpty(value)) target.emplace_back(value.key(), value.text());
}

std::optional<JsonValue> JsonMembers::child(JsonKey key) {
  return find(key, [] { return "a value"; });
}

std::optional<JsonValue> JsonMembers::object(JsonKey key) { return findOf(JsonKind::kObject, key); }

std::vector<JsonValue> JsonMembers::elements(JsonKey key) {
  std::vector<JsonValue> all;
  if (const auto list = findOf(JsonKind::kArray, key))
    for (const JsonValue value : *list) all.push_back(value);
  return all;
}

bool JsonMembers::has(std::string_view key) const { return object_ && object_->find(key); }

void JsonMembers::refuseOthers() {
  if (error_) return;
  const auto unknown = others();
  if (unknown.empty()) return;
  error_ = Error{ErrorCode::kSchema, {}, unknown[0].pointer(), "an unknown key", oneOf(asked_)};
}

std::vector<JsonValue> JsonMembers::others() const {
  std::vector<JsonValue> all;
  if (!object_) return all;
  for (const JsonValue member : *object_)
    if (std::find(asked_.begin(), asked_.end(), member.key()) == asked_.end()) all.push_back(member);
  return all;
}

}  // namespace tactus::base
