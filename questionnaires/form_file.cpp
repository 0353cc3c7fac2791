#include "questionnaires/form_file.h"

#include <algorithm>
#include <utility>

#include "core/base/check.h"
#include "questionnaires/embedded_data.h"
#include "questionnaires/json_reading.h"
#include "questionnaires/rule_sentence.h"

namespace tactus::questionnaires {
namespace {

using base::ErrorCode;
using base::fail;
using base::Result;

Result<study::FormItem> formItem(const JsonPlace& json, const AliasTable& aliases) {
  const auto number = json.member("number").and_then([](const JsonPlace& place) { return place.integer(); });
  if (!number) return tl::unexpected(number.error());
  auto text = json.string("text");
  if (!text) return tl::unexpected(text.error());
  auto sentence = parseRuleSentence(*text, aliases);
  if (!sentence) {
    base::Error error = sentence.error();
    error.place = json.pointer + "/text: " + error.place;
    return tl::unexpected(std::move(error));
  }
  if (!sentence->then.empty()) {
    return fail(ErrorCode::kValue, json.pointer + "/text", "a sentence with its answer",
                "a sentence that ends with IS");
  }
  return study::FormItem{*number, std::move(*text), std::move(sentence->conditions)};
}

Result<std::vector<study::FormItem>> formItems(const JsonPlace& json, const AliasTable& aliases) {
  const auto places = json.array();
  if (!places) return tl::unexpected(places.error());
  if (places->empty()) return fail(ErrorCode::kValue, json.pointer, "no items", "at least one item");
  std::vector<study::FormItem> items;
  for (const auto& place : *places) {
    auto item = formItem(place, aliases);
    if (!item) return tl::unexpected(item.error());
    for (const auto& earlier : items) {
      const std::string number = std::to_string(item->number);
      if (earlier.number == item->number) {
        return fail(ErrorCode::kValue, place.pointer + "/number", number + " again", "each number once");
      }
      if (earlier.conditions == item->conditions) {
        return fail(ErrorCode::kValue, place.pointer + "/text",
                    "the condition of item " + std::to_string(earlier.number), "another condition for each item");
      }
    }
    items.push_back(std::move(*item));
  }
  return items;
}

Result<std::vector<study::AnswerWord>> answerWords(const JsonPlace& json, const AliasTable& aliases) {
  const auto words = json.strings();
  if (!words) return tl::unexpected(words.error());
  std::vector<study::AnswerWord> answers;
  for (const auto& word : *words) {
    auto term = aliases.output.term(word);
    if (!term) return fail(ErrorCode::kReference, json.pointer, base::quoted(word), "words for terms of the output");
    answers.push_back({word, std::move(*term)});
  }
  return answers;
}

Result<study::Form> form(const JsonPlace& json, const AliasTable& aliases) {
  study::Form form;
  const std::pair<std::string_view, std::string*> texts[] = {
      {"id", &form.id}, {"title", &form.title}, {"source", &form.source}, {"depth_terms", &form.depth_terms}};
  for (const auto& [key, target] : texts) {
    auto text = json.string(key);
    if (!text) return tl::unexpected(text.error());
    *target = std::move(*text);
  }
  const auto version = json.member("version").and_then([](const JsonPlace& place) { return place.integer(); });
  if (!version) return tl::unexpected(version.error());
  form.version = *version;
  auto answers = json.member("answers").and_then([&](const JsonPlace& place) { return answerWords(place, aliases); });
  if (!answers) return tl::unexpected(answers.error());
  form.answers = std::move(*answers);
  auto items = json.member("items").and_then([&](const JsonPlace& place) { return formItems(place, aliases); });
  if (!items) return tl::unexpected(items.error());
  form.items = std::move(*items);
  return form;
}

}  // namespace

Result<study::Form> parseForm(std::string_view text, const std::string& file, const AliasTable& aliases) {
  const auto json = parseJson(text, "tactus-form");
  if (!json) return base::inFile(json.error(), file);
  auto read = form({&*json, {}}, aliases);
  if (!read) return base::inFile(read.error(), file);
  return read;
}

study::Form ngtForceForm() {
  auto read = parseForm(ngtForceFormJson(), "ngt_force_v1.json", ngtAliases());
  TACTUS_CHECK(read.has_value());
  return std::move(*read);
}

}  // namespace tactus::questionnaires
