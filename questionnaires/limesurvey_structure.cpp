#include <array>

#include "questionnaires/survey_files.h"

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

/// Groups, questions and answers in one language.
std::string contents(const Survey& survey) {
  const std::string language = limeSurveyLanguage(survey.language);
  std::string out = line({"G", "1", survey.code_label, "1", "", language});
  out += line({"Q", "S", "code", "1", survey.code_label, language, true});
  std::size_t group = 1;
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

}  // namespace tactus::questionnaires
