#include "questionnaires/scale_form.h"

#include <utility>

#include "core/base/check.h"
#include "questionnaires/embedded_data.h"
#include "questionnaires/json_reading.h"

namespace tactus::questionnaires {
namespace {

using base::ErrorCode;
using base::fail;
using base::Result;

constexpr int kFewestPoints = 2;
constexpr int kMostPoints = 101;

Result<int> number(const JsonPlace& json, std::string_view key) {
  return json.member(key).and_then([](const JsonPlace& place) { return place.integer(); });
}

Result<std::vector<ScaleItem>> scaleItems(const JsonPlace& json) {
  const auto places = json.array();
  if (!places) return tl::unexpected(places.error());
  if (places->empty()) return fail(ErrorCode::kValue, json.pointer, "no items", "at least one item");
  std::vector<ScaleItem> items;
  for (const auto& place : *places) {
    const auto at = number(place, "number");
    if (!at) return tl::unexpected(at.error());
    auto text = place.string("text");
    if (!text) return tl::unexpected(text.error());
    for (const auto& earlier : items) {
      if (earlier.number == *at) {
        return fail(ErrorCode::kValue, place.pointer + "/number", std::to_string(*at) + " again", "each number once");
      }
      if (earlier.text == *text) {
        return fail(ErrorCode::kValue, place.pointer + "/text",
                    "the statement of item " + std::to_string(earlier.number), "another statement for each item");
      }
    }
    items.push_back({*at, std::move(*text)});
  }
  return items;
}

Result<ScaleForm> scaleForm(const JsonPlace& json) {
  ScaleForm form;
  const std::pair<std::string_view, std::string*> texts[] = {
      {"id", &form.id}, {"title", &form.title}, {"source", &form.source}, {"low", &form.low}, {"high", &form.high}};
  for (const auto& [key, target] : texts) {
    auto text = json.string(key);
    if (!text) return tl::unexpected(text.error());
    *target = std::move(*text);
  }
  const std::pair<std::string_view, int*> numbers[] = {{"version", &form.version}, {"points", &form.points}};
  for (const auto& [key, target] : numbers) {
    const auto value = number(json, key);
    if (!value) return tl::unexpected(value.error());
    *target = *value;
  }
  if (form.points < kFewestPoints || form.points > kMostPoints) {
    return fail(ErrorCode::kValue, json.pointer + "/points", std::to_string(form.points),
                std::to_string(kFewestPoints) + " to " + std::to_string(kMostPoints) + " points");
  }
  auto items = json.member("items").and_then(scaleItems);
  if (!items) return tl::unexpected(items.error());
  form.items = std::move(*items);
  return form;
}

}  // namespace

Result<ScaleForm> parseScaleForm(std::string_view text, const std::string& file) {
  const auto json = parseJson(text, "tactus-scale-form");
  if (!json) return base::inFile(json.error(), file);
  auto read = scaleForm({&*json, {}});
  if (!read) return base::inFile(read.error(), file);
  return read;
}

ScaleForm usabilityForm() {
  auto read = parseScaleForm(usabilityFormJson(), "usability_v1.json");
  TACTUS_CHECK(read.has_value());
  return std::move(*read);
}

}  // namespace tactus::questionnaires
