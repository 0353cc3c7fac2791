#include "questionnaires/wording.h"

#include <algorithm>
#include <utility>

#include "questionnaires/json_reading.h"

namespace tactus::questionnaires {
namespace {

using base::ErrorCode;
using base::fail;
using base::Result;

Result<void> addPhrases(const JsonPlace& json, Wording& wording) {
  const auto inputs = json.object();
  if (!inputs) return tl::unexpected(inputs.error());
  for (const auto& [input, place] : *inputs) {
    const auto terms = place.object();
    if (!terms) return tl::unexpected(terms.error());
    for (const auto& [term, text_place] : *terms) {
      auto text = text_place.string();
      if (!text) return tl::unexpected(text.error());
      wording.phrases.push_back({{input, term}, std::move(*text)});
    }
  }
  return {};
}

Result<void> addItems(const JsonPlace& json, Wording& wording) {
  const auto places = json.array();
  if (!places) return tl::unexpected(places.error());
  for (const auto& place : *places) {
    const auto number = place.member("number").and_then([](const JsonPlace& at) { return at.integer(); });
    if (!number) return tl::unexpected(number.error());
    auto text = place.string("text");
    if (!text) return tl::unexpected(text.error());
    if (wording.item(*number) != nullptr) {
      return fail(ErrorCode::kValue, place.pointer + "/number", std::to_string(*number) + " again", "each number once");
    }
    wording.items.push_back({*number, std::move(*text)});
  }
  return {};
}

Result<void> addAnswers(const JsonPlace& json, Wording& wording) {
  const auto members = json.object();
  if (!members) return tl::unexpected(members.error());
  for (const auto& [value, place] : *members) {
    auto text = place.string();
    if (!text) return tl::unexpected(text.error());
    wording.answers.push_back({value, std::move(*text)});
  }
  return {};
}

Result<Wording> wordingFrom(const JsonPlace& json) {
  Wording wording;
  const std::pair<std::string_view, std::string*> texts[] = {{"form", &wording.form},
                                                             {"language", &wording.language},
                                                             {"title", &wording.title},
                                                             {"instructions", &wording.instructions}};
  for (const auto& [key, target] : texts) {
    auto text = json.string(key);
    if (!text) return tl::unexpected(text.error());
    *target = std::move(*text);
  }
  const auto version = json.member("form_version").and_then([](const JsonPlace& at) { return at.integer(); });
  if (!version) return tl::unexpected(version.error());
  wording.version = *version;
  if (auto remark = json.string("remark")) wording.remark = std::move(*remark);
  if (auto question = json.string("question")) wording.question = std::move(*question);

  using Add = Result<void> (*)(const JsonPlace&, Wording&);
  const std::pair<std::string_view, Add> parts[] = {{"phrases", addPhrases}, {"items", addItems}};
  for (const auto& [key, add] : parts) {
    const auto place = json.member(key);
    if (!place) continue;  // a wording has one of the two
    if (auto ok = add(*place, wording); !ok) return tl::unexpected(ok.error());
  }
  if (wording.phrases.empty() && wording.items.empty()) {
    return fail(ErrorCode::kSchema, "/", "neither 'phrases' nor 'items'", "the words of the items");
  }
  const auto answers = json.member("answers").and_then([&](const JsonPlace& at) { return addAnswers(at, wording); });
  if (!answers) return tl::unexpected(answers.error());
  return wording;
}

}  // namespace

std::optional<std::string> Wording::sentence(const std::vector<study::ItemCondition>& conditions) const {
  std::string text;
  for (const auto& condition : conditions) {
    const auto phrase = std::find_if(phrases.begin(), phrases.end(),
                                     [&](const Phrase& candidate) { return candidate.condition == condition; });
    if (phrase == phrases.end()) return std::nullopt;
    text += phrase->text + ' ';
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

Result<Wording> parseWording(std::string_view text, const std::string& file) {
  const auto json = parseJson(text, "tactus-form-wording");
  if (!json) return base::inFile(json.error(), file);
  auto read = wordingFrom({&*json, {}});
  if (!read) return base::inFile(read.error(), file);
  return read;
}

}  // namespace tactus::questionnaires
