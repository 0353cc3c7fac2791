#include "questionnaires/json_reading.h"

#include <utility>

#include "core/base/json/json_pointer.h"

namespace tactus::questionnaires {

using base::childPointer;
using base::ErrorCode;
using base::fail;
using base::Result;

namespace {

tl::unexpected<base::Error> wrongType(const JsonPlace& place, std::string wanted) {
  return fail(ErrorCode::kSchema, place.pointer, place.json->type_name(), std::move(wanted));
}

}  // namespace

Result<JsonPlace> JsonPlace::member(std::string_view key) const {
  if (!json->is_object()) return wrongType(*this, "an object");
  const auto it = json->find(std::string(key));
  if (it == json->end()) {
    return fail(ErrorCode::kSchema, pointer.empty() ? "/" : pointer, "no key " + base::quoted(key),
                "the key " + base::quoted(key));
  }
  return JsonPlace{&*it, childPointer(pointer, key)};
}

JsonPlace JsonPlace::element(std::size_t index) const { return {&json->at(index), childPointer(pointer, index)}; }

Result<std::string> JsonPlace::string() const {
  if (!json->is_string()) return wrongType(*this, "a text");
  auto text = json->get<std::string>();
  if (text.empty()) return fail(ErrorCode::kValue, pointer, "an empty text", "a text");
  return text;
}

Result<int> JsonPlace::integer() const {
  if (!json->is_number_integer()) return wrongType(*this, "an integer");
  const auto value = json->get<long long>();
  if (value < 1 || value > 1'000'000) {
    return fail(ErrorCode::kValue, pointer, std::to_string(value), "an integer from 1 to 1000000");
  }
  return static_cast<int>(value);
}

Result<std::vector<JsonPlace>> JsonPlace::array() const {
  if (!json->is_array()) return wrongType(*this, "an array");
  std::vector<JsonPlace> elements;
  for (std::size_t i = 0; i < json->size(); ++i) elements.push_back(element(i));
  return elements;
}

Result<std::vector<std::pair<std::string, JsonPlace>>> JsonPlace::object() const {
  if (!json->is_object()) return wrongType(*this, "an object");
  std::vector<std::pair<std::string, JsonPlace>> members;
  for (const auto& entry : json->items()) {
    members.emplace_back(entry.key(), JsonPlace{&entry.value(), childPointer(pointer, entry.key())});
  }
  return members;
}

Result<std::vector<std::string>> JsonPlace::strings() const {
  const auto elements = array();
  if (!elements) return tl::unexpected(elements.error());
  std::vector<std::string> texts;
  for (const auto& place : *elements) {
    auto text = place.string();
    if (!text) return tl::unexpected(text.error());
    texts.push_back(std::move(*text));
  }
  return texts;
}

Result<std::string> JsonPlace::string(std::string_view key) const {
  const auto place = member(key);
  if (!place) return tl::unexpected(place.error());
  return place->string();
}

Result<Json> parseJson(std::string_view text, std::string_view format) {
  Json json = Json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (json.is_discarded()) return fail(ErrorCode::kSyntax, {}, "text that is not JSON", "a JSON text");
  const auto found = JsonPlace{&json, {}}.string("format");
  if (!found) return tl::unexpected(found.error());
  if (*found != format) return fail(ErrorCode::kSchema, "/format", base::quoted(*found), base::quoted(format));
  return json;
}

}  // namespace tactus::questionnaires
