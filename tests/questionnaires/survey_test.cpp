// A form outside of the program: the formats as REDCap's and LimeSurvey's own files have them.
#include "questionnaires/survey.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

#include "core/base/tables/csv.h"
#include "questionnaires/form_file.h"

#include "tests/support/default_procedure.h"

namespace tactus::questionnaires {
namespace {

Survey forceSurvey(std::string_view language = "en") {
  auto made = survey(support::defaultProcedure(), "ngt-force-v1", language);
  EXPECT_TRUE(made.has_value());
  return *made;
}

base::CsvTable tableOf(const std::string& text) {
  auto table = base::CsvTable::parse(text, "table.csv");
  EXPECT_TRUE(table.has_value()) << table.error().message();
  return *table;
}

std::vector<std::vector<std::string>> tabbed(const std::string& text) {
  std::vector<std::vector<std::string>> rows(1, std::vector<std::string>(1));
  bool quoted = false;
  for (std::size_t k = 0; k + 1 < text.size(); ++k) {
    if (text[k] == '"') {
      if (quoted && text[k + 1] == '"') {
        rows.back().back() += text[k++];
      } else {
        quoted = !quoted;
      }
    } else if (text[k] == '\t' && !quoted) {
      rows.back().emplace_back();
    } else if (text[k] == '\n' && !quoted) {
      rows.emplace_back(1);
    } else {
      rows.back().back() += text[k];
    }
  }
  return rows;
}

TEST(SurveyForm, NineTablesOfFiveItems) {
  const Survey form = forceSurvey();
  EXPECT_EQ(form.name, "ngt_force");
  ASSERT_EQ(form.matrices.size(), 9U);
  int item = 0;
  for (const SurveyMatrix& matrix : form.matrices) {
    EXPECT_EQ(matrix.fields.size(), 5U);
    for (const SurveyField& field : matrix.fields) {
      EXPECT_EQ(field.item, ++item);
      const auto shared = [&](const study::ItemCondition& condition) {
        const auto& first = matrix.fields.front().conditions;
        return condition.input != "depth" && std::find(first.begin(), first.end(), condition) != first.end();
      };
      EXPECT_TRUE(std::any_of(field.conditions.begin(), field.conditions.end(), shared)) << field.name;
    }
  }
  EXPECT_EQ(form.matrices[0].fields[0].name, "q01");
  EXPECT_EQ(form.matrices[8].fields[4].name, "q45");
}

TEST(SurveyForm, TwoWordingsHaveTwoNames) {
  EXPECT_EQ(forceSurvey().wording, "plain");
  EXPECT_NE(forceSurvey().matrices[0].fields[0].text.find("How large is the force?"), std::string::npos);
  const auto published = survey(support::defaultProcedure(), "ngt-force-v1", "en", "published");
  ASSERT_TRUE(published.has_value());
  EXPECT_EQ(published->name, "ngt_force_published");
  EXPECT_NE(published->matrices[0].fields[0].text.find("THEN Force Change IS"), std::string::npos);
}

TEST(SurveyForm, CodesLeadBackToTerms) {
  const auto codes = tableOf(codeTable(forceSurvey()));
  ASSERT_EQ(codes.rowCount(), 6U);
  const std::vector<std::string> terms = {"very_small", "small", "medium", "large", "very_large", ""};
  const std::vector<std::string> numbers = {"1", "2", "3", "4", "5", "9"};
  for (std::size_t row = 0; row < 6; ++row) {
    EXPECT_EQ(codes.cell(row, 0), numbers[row]);
    EXPECT_EQ(codes.cell(row, 1), terms[row]);
    EXPECT_EQ(codes.cell(row, 2), row < 5 ? "answered" : "cant_tell");
  }
  const auto fields = tableOf(fieldTable(forceSurvey()));
  ASSERT_EQ(fields.rowCount(), 45U);
  const auto form = support::ngtForceForm();
  for (std::size_t row = 0; row < 45; ++row) {
    EXPECT_EQ(*fields.integer(row, 2), form.items[row].number);
    for (const auto& condition : form.items[row].conditions) {
      EXPECT_EQ(fields.cell(row, *fields.require(condition.input)), condition.term);
    }
  }
}

TEST(SurveyForm, RedcapHeadersInTheirOrder) {
  const auto table = tableOf(redcapDictionary(forceSurvey()));
  const std::vector<std::string> headers = {"Variable / Field Name",
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
                                            "Field Annotation"};
  EXPECT_EQ(table.columns(), headers);
}

TEST(SurveyForm, RedcapRows) {
  for (const std::string& language : languagesOf(support::defaultProcedure(), "ngt-force-v1")) {
    const Survey form = forceSurvey(language);
    const auto table = tableOf(redcapDictionary(form));
    ASSERT_EQ(table.rowCount(), 47U) << "the record id, the introduction and 45 items";
    EXPECT_EQ(table.cell(0, 0), "record_id");
    EXPECT_EQ(table.cell(0, 3), "text");
    EXPECT_EQ(table.cell(1, 3), "descriptive");
    std::set<std::string> names;
    for (std::size_t row = 0; row < table.rowCount(); ++row) {
      const std::string name(table.cell(row, 0));
      EXPECT_TRUE(names.insert(name).second) << name;
      EXPECT_LE(name.size(), 26U);
      EXPECT_TRUE(std::all_of(name.begin(), name.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
      })) << name;
      EXPECT_EQ(table.cell(row, 1), "ngt_force");
    }
    for (std::size_t row = 2; row < 47; ++row) {
      EXPECT_EQ(table.cell(row, 3), "radio");
      EXPECT_EQ(table.cell(row, 5), table.cell(2, 5)) << "choices are equal within a matrix";
      EXPECT_EQ(table.cell(row, 2).empty(), (row - 2) % 5 != 0) << "a heading for each table";
    }
    EXPECT_EQ(table.cell(2, 15), "m01");
    EXPECT_EQ(table.cell(46, 15), "m09");
  }
  const auto table = tableOf(redcapDictionary(forceSurvey()));
  EXPECT_EQ(table.cell(2, 5), "1, Very small | 2, Small | 3, Medium | 4, Large | 5, Very large | 9, I can't tell");
  EXPECT_EQ(table.cell(2, 4),
            "The tube is poorly lubricated. The tip of the tube is in the nasal cavity. How large is the force?");
  const auto published =
      tableOf(redcapDictionary(*survey(support::defaultProcedure(), "ngt-force-v1", "en", "published")));
  EXPECT_EQ(published.cell(2, 5), "1, Very Small | 2, Small | 3, Medium | 4, Large | 5, Very Large | 9, I can't tell");
  EXPECT_EQ(published.cell(2, 4), support::ngtForceForm().items[0].text);
}

TEST(SurveyForm, LimeSurveyStructureInTwoLanguages) {
  const std::vector<Survey> languages = {forceSurvey("en"), forceSurvey("zh-Hant")};
  const auto rows = tabbed(limeSurveyStructure(languages));
  const std::vector<std::string> head = {"class",    "type/scale", "name",      "relevance", "text",    "help",
                                         "language", "validation", "mandatory", "other",     "default", "same_default"};
  EXPECT_EQ(rows[0], head);
  std::size_t arrays = 0, items = 0, answers = 0;
  std::vector<std::string> order;
  for (const auto& row : rows) {
    ASSERT_EQ(row.size(), head.size());
    if (row[0] == "Q" && row[1] == "F") ++arrays;
    if (row[0] == "SQ") ++items;
    if (row[0] == "A") {
      ++answers;
      EXPECT_LE(row[2].size(), 5U) << "longer codes vanish";
    }
    EXPECT_LE(row[2].size(), 20U) << "question codes";
    if (row[0] == "G" || row[0] == "Q" || row[0] == "SQ" || row[0] == "A") {
      if (order.empty() || order.back() != row[6]) order.push_back(row[6]);
    }
  }
  EXPECT_EQ(arrays, 18U);
  EXPECT_EQ(items, 90U);
  EXPECT_EQ(answers, 108U);
  EXPECT_EQ(order, (std::vector<std::string>{"en", "zh-Hant-TW"})) << "all of the base language first";
  EXPECT_EQ(rows[1][2], "language");
  EXPECT_EQ(rows[2][2], "additional_languages");
  EXPECT_EQ(rows[2][4], "zh-Hant-TW");
}

TEST(SurveyForm, AScaleOfAgreement) {
  const auto form = survey(support::defaultProcedure(), "usability-v1", "en");
  ASSERT_TRUE(form.has_value());
  ASSERT_EQ(form->matrices.size(), 1U);
  EXPECT_EQ(form->matrices[0].fields.size(), 6U);
  ASSERT_EQ(form->choices.size(), 7U);
  EXPECT_EQ(form->choices[0].label, "1 strongly disagree");
  EXPECT_EQ(form->choices[3].label, "4");
  EXPECT_EQ(form->choices[6].code, "7");
  EXPECT_FALSE(survey(support::defaultProcedure(), "ngt-force-v9", "en").has_value());
  EXPECT_FALSE(survey(support::defaultProcedure(), "ngt-force-v1", "fr").has_value());
}

}  // namespace
}  // namespace tactus::questionnaires
