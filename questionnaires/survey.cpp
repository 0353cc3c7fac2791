#include "questionnaires/survey.h"

#include <algorithm>
#include <array>

#include "core/base/tables/csv.h"
#include "questionnaires/form_file.h"

namespace tactus::questionnaires {
namespace {

/// What a survey says besides the form. Those in Chinese and German are composed; no nurse has reviewed them.
struct SurveyWords {
  std::string_view language;
  std::string_view code;
  std::string_view cannot_tell;
};

constexpr std::array<SurveyWords, 4> kWords = {{
    {"en", "Participant code", "I can't tell"},
    {"de", "Code der teilnehmenden Person", "Kann ich nicht sagen"},
    {"zh-Hant", "參加者代碼", "我無法判斷"},
    {"zh-Hans", "参加者代码", "我无法判断"},
}};

const SurveyWords& wordsIn(std::string_view language) {
  const auto* const found =
      std::find_if(kWords.begin(), kWords.end(), [&](const SurveyWords& words) { return words.language == language; });
  return found == kWords.end() ? kWords[0] : *found;
}

std::string numbered(std::string_view letter, std::size_t number) {
  return std::string(letter) + (number < 10 ? "0" : "") + std::to_string(number);
}

/// `ngt_force` for `ngt-force-v1`; another wording than the usual one is named, so that two are never taken for one.
std::string nameOf(std::string_view form, const std::string& wording) {
  std::string name(form.substr(0, form.rfind("-v")));
  std::replace(name.begin(), name.end(), '-', '_');
  return wording == wordingsOf(form).front() ? name : name + '_' + wording;
}

/// Terms count from the smallest force; points of a scale are codes already.
std::vector<SurveyChoice> choicesOf(const Questionnaire& words, bool scale) {
  std::vector<SurveyChoice> out;
  for (const Choice& choice : words.choices) {
    const std::string code = scale ? choice.value : std::to_string(out.size() + 1);
    std::string label = choice.label;
    if (scale) label = label.empty() ? choice.value : choice.value + " " + label;
    out.push_back({code, choice.value, "answered", std::move(label)});
  }
  if (!scale) out.push_back({"9", "", "cant_tell", std::string(wordsIn(words.language).cannot_tell)});
  return out;
}

}  // namespace

base::Result<Survey> survey(std::string_view form, std::string_view language, std::string_view wording) {
  const auto words = questionnaire(form, language, wording);
  if (!words) return tl::unexpected(words.error());
  const study::Form rules = ngtForceForm();
  const bool scale = rules.id != form;
  Survey out{
      words->form,  words->version,      nameOf(form, words->wording),        words->wording,           words->language,
      words->title, words->instructions, std::string(wordsIn(language).code), choicesOf(*words, scale), {}};
  std::vector<study::ItemCondition> common;  // to all fields of the last matrix
  for (const Question& question : words->questions) {
    SurveyField field{numbered("q", static_cast<std::size_t>(question.number)), question.number, question.text, {}};
    for (const study::FormItem& item : rules.items) {
      if (!scale && item.number == question.number) field.conditions = item.conditions;
    }
    std::vector<study::ItemCondition> shared;
    for (const auto& condition : common) {
      const auto& own = field.conditions;
      if (std::find(own.begin(), own.end(), condition) != own.end()) shared.push_back(condition);
    }
    const bool opens = out.matrices.empty() || (shared.empty() && !field.conditions.empty());
    if (opens) out.matrices.push_back({numbered("m", out.matrices.size() + 1), {}});
    common = opens ? field.conditions : std::move(shared);
    out.matrices.back().fields.push_back(std::move(field));
  }
  return out;
}

std::string fieldTable(const Survey& survey) {
  std::vector<std::string> columns = {"field", "form", "item"};
  for (const SurveyMatrix& matrix : survey.matrices) {
    for (const SurveyField& field : matrix.fields) {
      for (const auto& condition : field.conditions) {
        if (std::find(columns.begin(), columns.end(), condition.input) == columns.end())
          columns.push_back(condition.input);
      }
    }
  }
  base::CsvWriter csv{std::span<const std::string>(columns)};
  for (const SurveyMatrix& matrix : survey.matrices) {
    for (const SurveyField& field : matrix.fields) {
      csv.cell(field.name).cell(survey.form).cell(field.item);
      for (std::size_t column = 3; column < columns.size(); ++column) {
        const auto it = std::find_if(field.conditions.begin(), field.conditions.end(),
                                     [&](const auto& condition) { return condition.input == columns[column]; });
        csv.cell(it == field.conditions.end() ? std::string() : it->term);
      }
      csv.endRow();
    }
  }
  return csv.text();
}

std::string codeTable(const Survey& survey) {
  base::CsvWriter csv({"code", "term", "status"});
  for (const SurveyChoice& choice : survey.choices) {
    csv.cell(choice.code).cell(choice.term).cell(choice.status).endRow();
  }
  return csv.text();
}

}  // namespace tactus::questionnaires
