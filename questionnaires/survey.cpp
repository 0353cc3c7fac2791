#include "questionnaires/survey.h"

#include <algorithm>
#include <array>

#include "core/base/error.h"
#include "core/base/tables/csv.h"
#include "questionnaires/form_file.h"

namespace tactus::questionnaires {
namespace {

constexpr std::string_view kHead =
    "class\ttype/scale\tname\trelevance\ttext\thelp\tlanguage\tvalidation\tmandatory\tother\tdefault\tsame_default\n";

/// One row of the structure; members that it has not stay empty.
struct StructureRow {
  std::string_view kind;
  std::string_view type;
  std::string_view name;
  std::string_view relevance;
  std::string_view text;
  std::string_view language;
  bool question = false;
};

std::string quotedCell(std::string_view text) {
  if (text.empty()) return {};
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + '"';
}

std::string line(const StructureRow& row) {
  std::string out(row.kind);
  for (const std::string_view cell : {row.type, row.name, row.relevance}) out += '\t' + std::string(cell);
  out += '\t' + quotedCell(row.text) + "\t\t" + std::string(row.language) + '\t';
  return out + (row.question ? "\tN\tN" : "\t\t") + "\t\t\n";
}

std::string paragraphs(const std::vector<std::string>& lines) {
  std::string out;
  for (const std::string& line : lines) out += (out.empty() ? "" : "\n") + line;
  return out;
}

/// A name without what question codes of LimeSurvey may not have.
std::string plainName(std::string name) {
  std::erase_if(name, [](char c) { return c == '_'; });
  return name;
}

/// Consent, profile and the words of the items, each a group; `group`: the number of the last one.
std::string openingContents(const SurveyOpening& opening, const std::string& language, std::size_t& group) {
  std::string out;
  if (!opening.consent.empty()) {
    out += line({"G", std::to_string(++group), opening.consent_title, "1", "", language});
    out += line({"Q", "X", "consenttext", "1", paragraphs(opening.consent), language, true});
    out += line({"Q", "L", "consent", "1", opening.consent_title, language, true});
    out += line({"A", "0", "1", "", opening.agree, language});
    out += line({"A", "0", "0", "", opening.decline, language});
  }
  out += line({"G", std::to_string(++group), opening.profile_title, "1", "", language});
  for (const SurveyOpening::Question& question : opening.profile) {
    out += line({"Q", "L", plainName(question.name), "1", question.text, language, true});
    int code = 0;
    for (const SurveyOpening::Offer& offer : question.offers)
      out += line({"A", "0", std::to_string(++code), "", offer.label, language});
  }
  out += line({"G", std::to_string(++group), opening.picture, "1", "", language});
  return out + line({"Q", "X", "words", "1", opening.picture + '\n' + paragraphs(opening.glossary), language, true});
}

/// Groups, questions and answers in one language.
std::string contents(const Survey& survey) {
  const std::string language = limeSurveyLanguage(survey.language);
  std::string out = line({"G", "1", survey.code_label, "1", "", language});
  out += line({"Q", "S", "code", "1", survey.code_label, language, true});
  std::size_t group = 1;
  if (survey.opening) out += openingContents(*survey.opening, language, group);
  for (const SurveyMatrix& matrix : survey.matrices) {
    const std::string range =
        std::to_string(matrix.fields.front().item) + " - " + std::to_string(matrix.fields.back().item);
    out += line({"G", std::to_string(++group), range, "1", "", language});
    out += line({"Q", "F", matrix.name, "1", survey.title, language, true});
    for (const SurveyField& field : matrix.fields) {
      out += line({"SQ", "0", field.name, "1", field.text, language});
    }
    for (const SurveyChoice& choice : survey.choices) {
      out += line({"A", "0", choice.code, "", choice.label, language});
    }
  }
  return out;
}

}  // namespace

std::string limeSurveyLanguage(std::string_view language) {
  if (language == "zh-Hant") return "zh-Hant-TW";
  return std::string(language);
}

std::string limeSurveyStructure(std::span<const Survey> languages) {
  std::string further;
  for (const Survey& survey : languages.subspan(1)) {
    further += (further.empty() ? "" : " ") + limeSurveyLanguage(survey.language);
  }
  std::string out(kHead);
  out += line({"S", "", "language", "", limeSurveyLanguage(languages.front().language), ""});
  if (!further.empty()) out += line({"S", "", "additional_languages", "", further, ""});
  out += line({"S", "", "format", "", "G", ""});
  for (const Survey& survey : languages) {
    const std::string language = limeSurveyLanguage(survey.language);
    out += line({"SL", "", "surveyls_title", "", survey.title, language});
    if (!survey.instructions.empty()) {
      out += line({"SL", "", "surveyls_welcometext", "", survey.instructions, language});
    }
  }
  for (const Survey& survey : languages) out += contents(survey);
  return out;
}

namespace {

constexpr std::array<std::string_view, 18> kColumns = {
    "Variable / Field Name",
    "Form Name",
    "Section Header",
    "Field Type",
    "Field Label",
    "Choices, Calculations, OR Slider Labels",
    "Field Note",
    "Text Validation Type OR Show Slider Number",
    "Text Validation Min",
    "Text Validation Max",
    "Identifier?",
    "Branching Logic (Show field only if...)",
    "Required Field?",
    "Custom Alignment",
    "Question Number (surveys only)",
    "Matrix Group Name",
    "Matrix Ranking?",
    "Field Annotation",
};
enum Column : std::size_t { kName, kForm, kHeader, kType, kLabel, kChoices, kNumber = 14, kMatrix };

using Row = std::array<std::string, kColumns.size()>;

/// A label between separators: `|` would end it.
std::string safe(std::string label) {
  for (char& c : label) {
    if (c == '|') c = '/';
  }
  return label;
}

std::string choicesText(const Survey& survey) {
  std::string text;
  for (const SurveyChoice& choice : survey.choices) {
    text += (text.empty() ? "" : " | ") + choice.code + ", " + safe(choice.label);
  }
  return text;
}

/// Consent and profile, as rows of the form that `row` names.
std::vector<Row> openingRows(const SurveyOpening& opening, const std::string& form) {
  std::vector<Row> out;
  const auto add = [&](const std::string& name, const char* type, const std::string& label, std::string choices) {
    Row row;
    row[kForm] = form;
    row[kName] = name;
    row[kType] = type;
    row[kLabel] = label;
    row[kChoices] = std::move(choices);
    out.push_back(std::move(row));
  };
  if (!opening.consent.empty()) {
    add(form + "_consent_text", "descriptive", paragraphs(opening.consent), {});
    out.back()[kHeader] = opening.consent_title;
    add("consent", "radio", opening.consent_title + " (" + opening.consent_version + ")",
        "1, " + safe(opening.agree) + " | 0, " + safe(opening.decline));
  }
  for (const SurveyOpening::Question& question : opening.profile) {
    std::string choices;
    for (const SurveyOpening::Offer& offer : question.offers)
      choices += (choices.empty() ? "" : " | ") + offer.code + ", " + safe(offer.label);
    add(question.name, "radio", question.text, std::move(choices));
    if (&question == &opening.profile.front()) out.back()[kHeader] = opening.profile_title;
  }
  return out;
}

}  // namespace

std::string redcapDictionary(const Survey& survey) {
  base::CsvWriter csv{std::vector<std::string>(kColumns.begin(), kColumns.end())};
  const auto add = [&](const Row& row) {
    for (const std::string& cell : row) csv.cell(cell);
    csv.endRow();
  };
  Row row;
  row[kForm] = survey.name;
  row[kName] = "record_id";
  row[kType] = "text";
  row[kLabel] = survey.code_label;
  add(row);
  if (survey.opening) {
    for (const Row& opening : openingRows(*survey.opening, survey.name)) add(opening);
  }
  row[kName] = survey.name + "_intro";
  row[kType] = "descriptive";
  row[kLabel] = survey.title + (survey.instructions.empty() ? "" : "\n" + survey.instructions);
  if (survey.opening) row[kLabel] += '\n' + survey.opening->picture + '\n' + paragraphs(survey.opening->glossary);
  add(row);
  row[kType] = "radio";
  row[kChoices] = choicesText(survey);
  for (const SurveyMatrix& matrix : survey.matrices) {
    row[kMatrix] = matrix.name;
    row[kHeader] = std::to_string(matrix.fields.front().item) + " – " + std::to_string(matrix.fields.back().item);
    for (const SurveyField& field : matrix.fields) {
      row[kName] = field.name;
      row[kLabel] = field.text;
      row[kNumber] = std::to_string(field.item);
      add(row);
      row[kHeader].clear();
    }
  }
  return csv.text();
}

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
std::string nameOf(const procedure::Procedure& procedure, std::string_view form, const std::string& wording) {
  std::string name(form.substr(0, form.rfind("-v")));
  std::replace(name.begin(), name.end(), '-', '_');
  return wording == wordingsOf(procedure, form).front() ? name : name + '_' + wording;
}

/// Terms count from the smallest force; points of a scale are codes already.
std::vector<SurveyChoice> choicesOf(const procedure::Procedure& procedure, const Questionnaire& words, bool scale) {
  std::vector<SurveyChoice> out;
  for (const Choice& choice : words.choices) {
    const std::string code = scale ? choice.value : std::to_string(out.size() + 1);
    std::string label = choice.label;
    if (scale) label = label.empty() ? choice.value : choice.value + " " + label;
    out.push_back({code, choice.value, "answered", std::move(label)});
  }
  if (!scale) {
    const auto own = procedure.words.find("w.cant_tell");
    const bool said = own != procedure.words.end() && own->second.contains(words.language);
    out.push_back({"9", "", "cant_tell",
                   said ? own->second.at(words.language) : std::string(wordsIn(words.language).cannot_tell)});
  }
  return out;
}

}  // namespace

base::Result<Survey> survey(const procedure::Procedure& procedure, std::string_view form, std::string_view language,
                            std::string_view wording) {
  TACTUS_TRY(const auto words, questionnaire(procedure, form, language, wording));
  const study::Form* const rules = procedure.form(form);
  const bool scale = rules == nullptr;
  Survey out{words.form,
             words.version,
             nameOf(procedure, form, words.wording),
             words.wording,
             words.language,
             words.title,
             words.instructions,
             std::string(wordsIn(language).code),
             choicesOf(procedure, words, scale),
             {}};
  std::vector<study::ItemCondition> common;  // to all fields of the last matrix
  for (const Question& question : words.questions) {
    SurveyField field{numbered("q", static_cast<std::size_t>(question.number)), question.number, question.text, {}};
    if (rules != nullptr) {
      const auto item = std::find_if(rules->items.begin(), rules->items.end(),
                                     [&](const auto& one) { return one.number == question.number; });
      if (item != rules->items.end()) field.conditions = item->conditions;
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
