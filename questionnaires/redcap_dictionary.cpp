#include <array>

#include "core/base/tables/csv.h"
#include "questionnaires/survey_files.h"

namespace tactus::questionnaires {
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
  row[kName] = survey.name + "_intro";
  row[kType] = "descriptive";
  row[kLabel] = survey.title + (survey.instructions.empty() ? "" : "\n" + survey.instructions);
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

}  // namespace tactus::questionnaires
