#include "questionnaires/form_file.h"

#include <utility>

#include "core/base/check.h"
#include "core/base/json/json_members.h"
#include "questionnaires/embedded_data.h"
#include "questionnaires/rule_sentence.h"

namespace tactus::questionnaires {
namespace {

using base::JsonMembers;
using base::required;

constexpr base::NumberRange kScaleNumbers{1, 1'000'000};
constexpr base::NumberRange kPoints{2, 101};

void readItems(JsonMembers& json, std::vector<ScaleItem>& items, std::optional<base::Error>& error) {
  for (const base::JsonValue value : json.elements(required("items"))) {
    JsonMembers members(value, error);
    ScaleItem item;
    members.integer(required("number"), item.number, kScaleNumbers);
    members.text(required("text"), item.text);
    members.refuseOthers();
    for (const auto& earlier : items) {
      if (earlier.number == item.number) {
        members.refuse("number", std::to_string(item.number) + " again", "each number once");
      }
      if (earlier.text == item.text) {
        members.refuse("text", "the statement of item " + std::to_string(earlier.number),
                       "another statement for each item");
      }
    }
    items.push_back(std::move(item));
  }
  if (items.empty()) json.refuse("items", "no items", "at least one item");
}

}  // namespace

base::Result<ScaleForm> parseScaleForm(std::string_view text, const std::string& file) {
  return base::readJson(text, file, [](JsonMembers& json, std::optional<base::Error>& error) {
    ScaleForm form;
    json.format("tactus-scale-form");
    json.text(required("id"), form.id);
    json.text(required("title"), form.title);
    json.text(required("source"), form.source);
    json.text(required("low"), form.low);
    json.text(required("high"), form.high);
    json.integer(required("version"), form.version, kScaleNumbers);
    json.integer(required("points"), form.points, kPoints);
    readItems(json, form.items, error);
    json.refuseOthers();
    return form;
  });
}

ScaleForm usabilityForm() {
  auto read = parseScaleForm(usabilityFormJson(), "usability_v1.json");
  TACTUS_CHECK(read.has_value());
  return std::move(*read);
}

namespace {

using base::ErrorCode;
using base::JsonMembers;
using base::required;

constexpr base::NumberRange kFromOne{1, 1'000'000};

/// The conditions of the item `text`, the member of this name in `json`.
std::vector<study::ItemCondition> conditionsIn(const std::string& text, JsonMembers& json, const AliasTable& aliases) {
  auto sentence = parseRuleSentence(text, aliases);
  if (!sentence) {
    json.refuse("text", std::move(sentence.error()));
    return {};
  }
  if (!sentence->then.empty()) json.refuse("text", "a sentence with its answer", "a sentence that ends with IS");
  return std::move(sentence->conditions);
}

void readItems(JsonMembers& json, const AliasTable& aliases, std::vector<study::FormItem>& items,
               std::optional<base::Error>& error) {
  for (const base::JsonValue value : json.elements(required("items"))) {
    JsonMembers members(value, error);
    study::FormItem item;
    members.integer(required("number"), item.number, kFromOne);
    members.text(required("text"), item.text);
    members.refuseOthers();
    if (error) return;
    item.conditions = conditionsIn(item.text, members, aliases);
    for (const auto& earlier : items) {
      if (earlier.number == item.number) {
        members.refuse("number", std::to_string(item.number) + " again", "each number once");
      }
      if (earlier.conditions == item.conditions) {
        members.refuse("text", "the condition of item " + std::to_string(earlier.number),
                       "another condition for each item");
      }
    }
    items.push_back(std::move(item));
  }
  if (items.empty()) json.refuse("items", "no items", "at least one item");
}

study::Form readForm(JsonMembers& json, const AliasTable& aliases, std::optional<base::Error>& error) {
  study::Form form;
  json.format("tactus-form");
  json.text(required("id"), form.id);
  json.text(required("title"), form.title);
  json.text(required("source"), form.source);
  json.text(required("depth_terms"), form.depth_terms);
  json.integer(required("version"), form.version, kFromOne);
  std::vector<std::string> words;
  json.texts(required("answers"), words);
  for (auto& word : words) {
    const auto term = aliases.output.term(word);
    if (!term) json.refuse("answers", base::quoted(word), "words for terms of the output", ErrorCode::kReference);
    form.answers.push_back({std::move(word), term.value_or("")});
  }
  readItems(json, aliases, form.items, error);
  json.refuseOthers();
  return form;
}

}  // namespace

base::Result<study::Form> parseForm(std::string_view text, const std::string& file, const AliasTable& aliases) {
  return base::readJson(text, file, [&](JsonMembers& json, auto& error) { return readForm(json, aliases, error); });
}

study::Form ngtForceForm() {
  auto read = parseForm(ngtForceFormJson(), "ngt_force_v1.json", ngtAliases());
  TACTUS_CHECK(read.has_value());
  return std::move(*read);
}

}  // namespace tactus::questionnaires
