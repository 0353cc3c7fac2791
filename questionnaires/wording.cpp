#include "questionnaires/wording.h"

#include <algorithm>
#include <utility>

#include "core/base/json/json_members.h"

namespace tactus::questionnaires {
namespace {

using base::JsonMembers;
using base::JsonValue;
using base::required;

constexpr base::NumberRange kWordingNumbers{1, 1'000'000};

void readPhrases(const JsonValue& phrases, Wording& wording, std::optional<base::Error>& error) {
  JsonMembers inputs(phrases, error);
  for (const JsonValue input : phrases) {
    std::vector<JsonMembers::NamedText> terms;
    inputs.texts(input.key(), terms);
    for (auto& [term, text] : terms) wording.phrases.push_back({{std::string(input.key()), term}, std::move(text)});
  }
}

void readItems(JsonMembers& json, Wording& wording, std::optional<base::Error>& error) {
  for (const JsonValue value : json.elements("items")) {
    JsonMembers members(value, error);
    Wording::Item item;
    members.integer(required("number"), item.number, kWordingNumbers);
    members.text(required("text"), item.text);
    members.refuseOthers();
    if (wording.item(item.number) != nullptr) {
      members.refuse("number", std::to_string(item.number) + " again", "each number once");
    }
    wording.items.push_back(std::move(item));
  }
}

Wording readWording(JsonMembers& json, std::optional<base::Error>& error) {
  Wording wording;
  json.format("tactus-form-wording");
  json.text(required("form"), wording.form);
  json.text(required("language"), wording.language);
  json.text(required("wording"), wording.wording);
  json.text(required("title"), wording.title);
  json.text(required("instructions"), wording.instructions);
  json.integer(required("form_version"), wording.version, kWordingNumbers);
  json.text("remark", wording.remark);
  json.text("question", wording.question);
  if (const auto phrases = json.object("phrases")) readPhrases(*phrases, wording, error);
  json.textOrEmpty("joiner", wording.joiner);
  json.texts("order", wording.order);
  readItems(json, wording, error);
  if (wording.phrases.empty() && wording.items.empty()) {
    json.refuse("phrases", "neither 'phrases' nor 'items'", "the words of the items");
  }
  std::vector<JsonMembers::NamedText> answers;
  json.texts(required("answers"), answers);
  for (auto& [value, text] : answers) wording.answers.push_back({std::move(value), std::move(text)});
  json.refuseOthers();
  return wording;
}

}  // namespace

std::optional<std::string> Wording::sentence(const std::vector<study::ItemCondition>& conditions) const {
  const auto place = [this](const study::ItemCondition& condition) {
    return std::find(order.begin(), order.end(), condition.input) - order.begin();
  };
  auto ordered = conditions;
  std::stable_sort(ordered.begin(), ordered.end(), [&](const auto& a, const auto& b) { return place(a) < place(b); });
  std::string text;
  for (const auto& condition : ordered) {
    const auto phrase = std::find_if(phrases.begin(), phrases.end(),
                                     [&](const Phrase& candidate) { return candidate.condition == condition; });
    if (phrase == phrases.end()) return std::nullopt;
    text += phrase->text + joiner;
  }
  return text + question;
}

const std::string* Wording::item(int number) const {
  const auto it = std::find_if(items.begin(), items.end(), [&](const Item& item) { return item.number == number; });
  return it == items.end() ? nullptr : &it->text;
}

const std::string* Wording::answer(std::string_view value) const {
  const auto it =
      std::find_if(answers.begin(), answers.end(), [&](const Label& label) { return label.value == value; });
  return it == answers.end() ? nullptr : &it->text;
}

base::Result<Wording> parseWording(std::string_view text, const std::string& file) {
  return base::readJson(text, file, readWording);
}

}  // namespace tactus::questionnaires
