#include "questionnaires/questionnaire.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/check.h"
#include "questionnaires/embedded_data.h"
#include "questionnaires/form_file.h"

namespace tactus::questionnaires {
namespace {

using base::ErrorCode;
using base::fail;
using base::Result;

constexpr std::string_view kPrinted = "en";
constexpr std::string_view kForceForm = "ngt-force-v1";
constexpr std::string_view kUsabilityForm = "usability-v1";

/// A wording that the program carries.
struct CarriedWording {
  std::string_view form;
  std::string_view language;
  std::string_view (*text)();
};

constexpr std::array kCarried = {
    CarriedWording{kForceForm, "en-x-plain", &ngtForcePlainWordingJson},
    CarriedWording{kForceForm, "de", &ngtForceGermanWordingJson},
    CarriedWording{kForceForm, "zh-Hant", &ngtForceTraditionalChineseWordingJson},
    CarriedWording{kForceForm, "zh-Hans", &ngtForceSimplifiedChineseWordingJson},
    CarriedWording{kUsabilityForm, "de", &usabilityGermanWordingJson},
    CarriedWording{kUsabilityForm, "zh-Hant", &usabilityTraditionalChineseWordingJson},
    CarriedWording{kUsabilityForm, "zh-Hans", &usabilitySimplifiedChineseWordingJson},
};

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

Result<Questionnaire> framed(const std::string& form, int version, const Wording& wording) {
  if (wording.form != form || wording.version != version) {
    return fail(ErrorCode::kReference, "wording in " + base::quoted(wording.language),
                base::quoted(wording.form) + " version " + std::to_string(wording.version),
                base::quoted(form) + " version " + std::to_string(version));
  }
  return Questionnaire{form, version, wording.language, wording.title, wording.instructions, wording.remark, {}, {}};
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

}  // namespace

const Choice* Questionnaire::choice(std::string_view value) const {
  const auto it = std::find_if(choices.begin(), choices.end(), [&](const Choice& c) { return c.value == value; });
  return it == choices.end() ? nullptr : &*it;
}

Questionnaire asPrinted(const study::Form& form) {
  Questionnaire printed{form.id, form.version, std::string(kPrinted), form.title, {}, {}, {}, {}};
  for (const auto& answer : form.answers) printed.choices.push_back({answer.term, answer.word});
  for (const auto& item : form.items) printed.questions.push_back({item.number, item.text});
  return printed;
}

Questionnaire asPrinted(const ScaleForm& form) {
  Questionnaire printed{form.id, form.version, std::string(kPrinted), form.title, {}, {}, {}, {}};
  printed.choices = scaleChoices(form, form.low, form.high);
  for (const auto& item : form.items) printed.questions.push_back({item.number, item.text});
  return printed;
}

Result<Questionnaire> inWords(const study::Form& form, const Wording& wording) {
  auto worded = framed(form.id, form.version, wording);
  if (!worded) return worded;
  for (const auto& answer : form.answers) {
    const std::string* const label = wording.answer(answer.term);
    if (label == nullptr) return noWords(wording, "the answer " + base::quoted(answer.term));
    worded->choices.push_back({answer.term, *label});
  }
  for (const auto& item : form.items) {
    const std::string* const whole = wording.item(item.number);
    auto text = whole != nullptr ? *whole : wording.sentence(item.conditions);
    if (!text) return noWords(wording, "item " + std::to_string(item.number));
    worded->questions.push_back({item.number, std::move(*text)});
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

std::vector<std::string> questionnaireIds() { return {std::string(kForceForm), std::string(kUsabilityForm)}; }

std::vector<std::string> languagesOf(std::string_view form) {
  std::vector<std::string> languages;
  if (form == kForceForm || form == kUsabilityForm) languages.emplace_back(kPrinted);
  for (const auto& carried : kCarried) {
    if (carried.form == form) languages.emplace_back(carried.language);
  }
  return languages;
}

Result<Questionnaire> questionnaire(std::string_view form, std::string_view language) {
  const auto languages = languagesOf(form);
  if (languages.empty()) {
    return fail(ErrorCode::kReference, "form", base::quoted(form), "one of " + joined(questionnaireIds()));
  }
  const bool is_force = form == kForceForm;
  if (language == kPrinted) return is_force ? asPrinted(ngtForceForm()) : asPrinted(usabilityForm());
  for (const auto& carried : kCarried) {
    if (carried.form != form || carried.language != language) continue;
    const auto wording = parseWording(carried.text(), "wording in " + std::string(language));
    TACTUS_CHECK(wording.has_value());
    return is_force ? inWords(ngtForceForm(), *wording) : inWords(usabilityForm(), *wording);
  }
  return fail(ErrorCode::kReference, "language of " + base::quoted(form), base::quoted(language),
              "one of " + joined(languages));
}

}  // namespace tactus::questionnaires
