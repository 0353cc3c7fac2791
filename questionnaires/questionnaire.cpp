#include "questionnaires/questionnaire.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/check.h"
#include "core/base/json/json_members.h"
#include "core/base/text.h"
#include "questionnaires/form_file.h"

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

namespace {

using base::ErrorCode;
using base::fail;
using base::Result;

constexpr std::string_view kPrinted = "en";
constexpr std::string_view kUsabilityForm = "usability-v1";
constexpr std::string_view kAnyProcedure = "plain";  // the usability form where it does not name the tube of the paper

/// Words of the usability form that the program carries, besides the form itself, which is in English.
struct CarriedWording {
  std::string_view language;
  std::string_view (*text)();
};

constexpr std::array kCarried = {
    CarriedWording{"de", &usabilityGermanWordingJson},
    CarriedWording{"zh-Hant", &usabilityTraditionalChineseWordingJson},
    CarriedWording{"zh-Hans", &usabilitySimplifiedChineseWordingJson},
};

bool isOfPaper(const procedure::Procedure& procedure) { return procedure.id == procedure::defaultProcedure()->id; }

/// The published sentences name the tube of the paper: those of another procedure name none.
Questionnaire forAnyProcedure(Questionnaire questionnaire) {
  const auto all = base::JsonDocument::parse(usabilityAnyJson());
  TACTUS_CHECK(all.has_value());
  std::optional<base::Error> error;
  std::vector<JsonMembers::NamedText> sentences;
  JsonMembers(all->root(), error).texts(std::string_view(questionnaire.language), sentences);
  TACTUS_CHECK(!error);
  for (Question& question : questionnaire.questions) {
    for (const auto& [number, text] : sentences) {
      if (number == std::to_string(question.number)) question.text = text;
    }
  }
  questionnaire.wording = kAnyProcedure;
  return questionnaire;
}

Wording parsed(const CarriedWording& carried) {
  auto wording = parseWording(carried.text(), "wording in " + std::string(carried.language));
  TACTUS_CHECK(wording.has_value());
  return std::move(*wording);
}

Result<Questionnaire> framed(const std::string& form, int version, const Wording& wording) {
  if (wording.form != form || wording.version != version) {
    return fail(ErrorCode::kReference, "wording in " + base::quoted(wording.language),
                base::quoted(wording.form) + " version " + std::to_string(wording.version),
                base::quoted(form) + " version " + std::to_string(version));
  }
  return Questionnaire{
      form, version, wording.wording, wording.language, wording.title, wording.instructions, wording.remark, {}, {}};
}

tl::unexpected<base::Error> noWords(const Wording& wording, const std::string& what) {
  return fail(ErrorCode::kReference, "wording in " + base::quoted(wording.language), "no words for " + what,
              "words for every item and every answer");
}

/// The unnamed points of a scale are shown by their numbers.
std::vector<Choice> scaleChoices(const ScaleForm& form, const std::string& low, const std::string& high) {
  std::vector<Choice> choices;
  for (int point = 1; point <= form.points; ++point) {
    choices.push_back({std::to_string(point), point == 1 ? low : point == form.points ? high : std::string()});
  }
  return choices;
}

/// Question::block of each item.
std::vector<int> blocksOf(const std::vector<study::FormItem>& items, std::string_view way) {
  const auto besidesTheWay = [way](const study::FormItem& item) {
    auto conditions = item.conditions;
    std::erase_if(conditions, [way](const study::ItemCondition& condition) { return condition.input == way; });
    return conditions;
  };
  std::vector<int> blocks;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const bool same = i > 0 && besidesTheWay(items[i]) == besidesTheWay(items[i - 1]);
    blocks.push_back(i == 0 ? 1 : same ? blocks.back() : blocks.back() + 1);
  }
  return blocks;
}

}  // namespace

const Choice* Questionnaire::choice(std::string_view value) const {
  const auto it = std::find_if(choices.begin(), choices.end(), [&](const Choice& c) { return c.value == value; });
  return it == choices.end() ? nullptr : &*it;
}

Questionnaire asPrinted(const study::Form& form, std::string_view way, std::string_view language) {
  Questionnaire printed{
      form.id, form.version, std::string(kPublishedWording), std::string(language), form.title, {}, {}, {}, {}};
  for (const auto& answer : form.answers) printed.choices.push_back({answer.term, answer.word});
  const auto blocks = blocksOf(form.items, way);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    printed.questions.push_back({form.items[i].number, form.items[i].text, blocks[i]});
  }
  return printed;
}

Questionnaire asPrinted(const ScaleForm& form) {
  Questionnaire printed{
      form.id, form.version, std::string(kPublishedWording), std::string(kPrinted), form.title, {}, {}, {}, {}};
  printed.choices = scaleChoices(form, form.low, form.high);
  for (const auto& item : form.items) printed.questions.push_back({item.number, item.text});
  return printed;
}

Result<Questionnaire> inWords(const study::Form& form, const Wording& wording, std::string_view way) {
  auto worded = framed(form.id, form.version, wording);
  if (!worded) return worded;
  for (const auto& answer : form.answers) {
    const std::string* const label = wording.answer(answer.term);
    if (label == nullptr) return noWords(wording, "the answer " + base::quoted(answer.term));
    worded->choices.push_back({answer.term, *label});
  }
  const auto blocks = blocksOf(form.items, way);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const auto& item = form.items[i];
    const std::string* const whole = wording.item(item.number);
    auto text = whole != nullptr ? *whole : wording.sentence(item.conditions);
    if (!text) return noWords(wording, "item " + std::to_string(item.number));
    worded->questions.push_back({item.number, std::move(*text), blocks[i]});
  }
  return worded;
}

Result<Questionnaire> inWords(const ScaleForm& form, const Wording& wording) {
  auto worded = framed(form.id, form.version, wording);
  if (!worded) return worded;
  const std::string* const low = wording.answer("1");
  const std::string* const high = wording.answer(std::to_string(form.points));
  if (low == nullptr || high == nullptr) return noWords(wording, "the ends of the scale");
  worded->choices = scaleChoices(form, *low, *high);
  for (const auto& item : form.items) {
    const std::string* const text = wording.item(item.number);
    if (text == nullptr) return noWords(wording, "item " + std::to_string(item.number));
    worded->questions.push_back({item.number, *text});
  }
  return worded;
}

std::vector<std::string> questionnaireIds(const procedure::Procedure& procedure) {
  std::vector<std::string> out;
  for (const auto& form : procedure.forms) out.push_back(form.id);
  out.emplace_back(kUsabilityForm);
  return out;
}

namespace {

/// The wordings of the procedure's forms; checkWordings has read them before.
std::vector<Wording> wordingsIn(const procedure::Procedure& procedure) {
  std::vector<Wording> out;
  for (const std::string& path : procedure.wordings) {
    auto read = parseWording(procedure.files.at(path), path);
    TACTUS_CHECK(read.has_value());
    out.push_back(*std::move(read));
  }
  return out;
}

bool isKnown(const procedure::Procedure& procedure, const study::ItemCondition& condition) {
  if (condition == study::kWayOut) return true;
  const auto has = [&](const std::vector<fuzzy::Term>& terms) {
    return fuzzy::findTerm(terms, condition.term) != nullptr;
  };
  if (condition.input == procedure.wayInput().id) {
    return std::any_of(procedure.way_terms.begin(), procedure.way_terms.end(),
                       [&](const auto& set) { return has(set.terms); });
  }
  return std::any_of(procedure.inputs.begin(), procedure.inputs.end(),
                     [&](const auto& input) { return input.id == condition.input && has(input.terms); });
}

/// Whether each item stands in the form itself, word by word.
bool isPrinted(const study::Form& form) {
  return std::none_of(form.items.begin(), form.items.end(), [](const auto& item) { return item.text.empty(); });
}

}  // namespace

base::Result<void> checkWordings(const procedure::Procedure& procedure) {
  const std::string& first = procedure.languages.front();
  std::vector<std::string> worded;  // forms in the first language
  for (const std::string& path : procedure.wordings) {
    const std::string file = procedure.id + "/" + path;
    TACTUS_TRY(const auto wording, parseWording(procedure.files.at(path), file));
    const study::Form* const form = procedure.form(wording.form);
    if (form == nullptr) {
      return base::inFile({ErrorCode::kReference, {}, "/form", base::quoted(wording.form), "a form of the pack"}, file);
    }
    const auto& languages = procedure.languages;
    if (std::find(languages.begin(), languages.end(), wording.language) == languages.end()) {
      return base::inFile({ErrorCode::kReference,
                           {},
                           "/language",
                           base::quoted(wording.language),
                           "one of " + base::joined(languages, ", ")},
                          file);
    }
    for (const auto& item : form->items) {
      for (const auto& condition : item.conditions) {
        const bool said = wording.item(item.number) != nullptr ||
                          std::any_of(wording.phrases.begin(), wording.phrases.end(),
                                      [&](const auto& phrase) { return phrase.condition == condition; });
        if (said) continue;
        return base::inFile({ErrorCode::kReference,
                             {},
                             "/phrases",
                             "no phrase for " + base::quoted(condition.input + " " + condition.term) + " of item " +
                                 std::to_string(item.number),
                             "a phrase for each condition"},
                            file);
      }
    }
    for (const auto& phrase : wording.phrases) {
      if (isKnown(procedure, phrase.condition)) continue;
      return base::inFile({ErrorCode::kReference,
                           {},
                           "/phrases",
                           "a phrase for " + base::quoted(phrase.condition.input + " " + phrase.condition.term),
                           "an input of the procedure and one of its words"},
                          file);
    }
    for (const auto& answer : wording.answers) {
      const bool offered = std::any_of(form->answers.begin(), form->answers.end(),
                                       [&](const auto& one) { return one.term == answer.value; });
      if (offered) continue;
      return base::inFile({ErrorCode::kReference, {}, "/answers", base::quoted(answer.value), "an answer of the form"},
                          file);
    }
    if (auto ok = inWords(*form, wording, procedure.wayInput().id); !ok)
      return base::inFile(std::move(ok).error(), file);
    if (wording.language == first) worded.push_back(form->id);
  }
  for (const auto& form : procedure.forms) {
    if (isPrinted(form) || std::find(worded.begin(), worded.end(), form.id) != worded.end()) continue;
    return base::inFile({ErrorCode::kReference,
                         {},
                         "wordings",
                         "no wording of " + base::quoted(form.id) + " in " + base::quoted(first),
                         "one"},
                        procedure.id + "/procedure.json");
  }
  return {};
}

std::vector<std::string> wordingsOf(const procedure::Procedure& procedure, std::string_view form) {
  if (form == kUsabilityForm) return {std::string(isOfPaper(procedure) ? kPublishedWording : kAnyProcedure)};
  const study::Form* const known = procedure.form(form);
  if (known == nullptr) return {};
  std::vector<std::string> out;
  for (const Wording& wording : wordingsIn(procedure)) {
    if (wording.form == form && std::find(out.begin(), out.end(), wording.wording) == out.end())
      out.push_back(wording.wording);
  }
  if (isPrinted(*known)) out.emplace_back(kPublishedWording);
  return out;
}

std::vector<std::string> languagesOf(const procedure::Procedure& procedure, std::string_view form,
                                     std::string_view wording) {
  const auto wordings = wordingsOf(procedure, form);
  if (wordings.empty()) return {};
  if (wording.empty()) wording = wordings.front();
  std::vector<std::string> languages;
  if (form == kUsabilityForm) {
    if (wording != wordings.front()) return {};
    languages.emplace_back(kPrinted);
    for (const auto& carried : kCarried) languages.emplace_back(carried.language);
    return languages;
  }
  if (wording == kPublishedWording && isPrinted(*procedure.form(form)))
    languages.push_back(procedure.languages.front());
  for (const Wording& one : wordingsIn(procedure)) {
    if (one.form == form && one.wording == wording) languages.push_back(one.language);
  }
  return languages;
}

namespace {

/// Nothing in a language that the program does not carry.
std::optional<Questionnaire> usabilityIn(std::string_view language) {
  if (language == kPrinted) return asPrinted(usabilityForm());
  for (const auto& carried : kCarried) {
    if (carried.language != language) continue;
    auto worded = inWords(usabilityForm(), parsed(carried));
    TACTUS_CHECK(worded.has_value());
    return *std::move(worded);
  }
  return std::nullopt;
}

}  // namespace

Result<Questionnaire> questionnaire(const procedure::Procedure& procedure, std::string_view form,
                                    std::string_view language, std::string_view wording) {
  const auto wordings = wordingsOf(procedure, form);
  if (wordings.empty()) {
    return fail(ErrorCode::kReference, "form", base::quoted(form),
                "one of " + base::joined(questionnaireIds(procedure), ", "));
  }
  if (wording.empty()) wording = wordings.front();
  if (std::find(wordings.begin(), wordings.end(), wording) == wordings.end()) {
    return fail(ErrorCode::kReference, "wording of " + base::quoted(form), base::quoted(wording),
                "one of " + base::joined(wordings, ", "));
  }
  if (form == kUsabilityForm) {
    auto asked = usabilityIn(language);
    if (asked) return isOfPaper(procedure) ? *std::move(asked) : forAnyProcedure(*std::move(asked));
  } else {
    const std::string& way = procedure.wayInput().id;
    const study::Form& known = *procedure.form(form);
    for (const Wording& one : wordingsIn(procedure)) {
      if (one.form == form && one.wording == wording && one.language == language) return inWords(known, one, way);
    }
    if (wording == kPublishedWording && isPrinted(known) && language == procedure.languages.front())
      return asPrinted(known, way, language);
  }
  return fail(ErrorCode::kReference, "language of " + base::quoted(form) + " in the wording " + base::quoted(wording),
              base::quoted(language), "one of " + base::joined(languagesOf(procedure, form, wording), ", "));
}

Result<Wording> composedWording(const procedure::Procedure& procedure, std::string_view form,
                                std::string_view language) {
  std::vector<std::string> known;
  for (Wording& one : wordingsIn(procedure)) {
    if (one.form != form || one.phrases.empty()) continue;
    if (one.language == language) return std::move(one);
    known.push_back(one.language);
  }
  return fail(ErrorCode::kReference, "language of " + base::quoted(form), base::quoted(language),
              "one of " + base::joined(known, ", "));
}

}  // namespace tactus::questionnaires
