// The way back of a questionnaire: tables of responses in the shapes that REDCap and LimeSurvey export.
#include "questionnaires/survey_responses.h"

#include <gtest/gtest.h>

#include "questionnaires/questionnaire.h"

#include "tests/support/default_procedure.h"

namespace tactus::questionnaires {
namespace {

using Rows = std::vector<std::vector<std::string>>;
using Status = study::Answer::Status;

std::vector<Survey> forceSurveys() {
  std::vector<Survey> out;
  for (const std::string& language : languagesOf(support::defaultProcedure(), "ngt-force-v1"))
    out.push_back(*survey(support::defaultProcedure(), "ngt-force-v1", language));
  return out;
}

/// The code in the column of `item`: each code and no answer in turn, the same for everybody.
std::string codeOf(int item) {
  static const std::vector<std::string> codes = {"1", "2", "3", "4", "5", "9", ""};
  return codes[static_cast<std::size_t>(item) % codes.size()];
}

/// What `codeOf` means.
study::Answer answerOf(const std::string& participant, int item) {
  static const std::vector<std::string> terms = {"very_small", "small", "medium", "large", "very_large", "", ""};
  const std::size_t place = static_cast<std::size_t>(item) % terms.size();
  const Status status = place < 5 ? Status::kAnswered : place == 5 ? Status::kCantTell : Status::kSkipped;
  return {participant, "ngt-force-v1", item, terms[place], status, {}};
}

/// A cell as survey systems write it: in quotes where it must be.
std::string cell(const std::string& text, char separator) {
  if (text.find_first_of(std::string("\"\n") + separator) == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + '"';
}

std::string textOf(const Rows& rows, char separator = ',', const std::string& end = "\n") {
  std::string out;
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i)
      out += (i > 0 ? std::string(1, separator) : "") + cell(row[i], separator);
    out += end;
  }
  return out;
}

/// An export of two records, with the columns that REDCap adds.
Rows redcapRows() {
  Rows rows = {{"record_id", "redcap_survey_identifier", "ngt_force_timestamp"},
               {"velvet-otter", "", "2026-11-20 09:00:00"},
               {"amber-lynx", "", "[not completed]"}};
  for (int item = 1; item <= 45; ++item) {
    rows[0].push_back((item < 10 ? "q0" : "q") + std::to_string(item));
    rows[1].push_back(codeOf(item));
    rows[2].push_back(codeOf(item));
  }
  rows[0].emplace_back("ngt_force_complete");
  rows[1].emplace_back("2");
  rows[2].emplace_back("0");
  return rows;
}

base::Result<SurveyResponses> responsesIn(const std::string& text, const ResponseSettings& settings = {}) {
  const auto table = base::CsvTable::parse(text, "responses.csv");
  if (!table) return tl::unexpected(table.error());
  const auto languages = forceSurveys();
  return surveyResponses(*table, languages, settings);
}

void expectBoth(const base::Result<SurveyResponses>& read) {
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->participants, (std::vector<std::string>{"velvet-otter", "amber-lynx"}));
  std::vector<study::Answer> wanted;
  for (const std::string& participant : read->participants) {
    for (int item = 1; item <= 45; ++item) wanted.push_back(answerOf(participant, item));
  }
  EXPECT_EQ(read->answers, wanted);
}

std::string errorOf(const Rows& rows, const ResponseSettings& settings = {}) {
  const auto read = responsesIn(textOf(rows), settings);
  return read ? "" : read.error().message();
}

TEST(SurveyResponses, AreTheSameWithEveryDelimiterMarkAndLineEnd) {
  for (const char separator : {',', ';', '\t', '|', '^'}) {
    for (const std::string mark : {"", "\xEF\xBB\xBF"}) {
      for (const std::string end : {"\n", "\r\n"}) expectBoth(responsesIn(mark + textOf(redcapRows(), separator, end)));
    }
  }
}

TEST(SurveyResponses, AreTheSameAsLabelsInEveryLanguage) {
  for (const Survey& survey : forceSurveys()) {
    Rows rows = redcapRows();
    for (std::size_t row = 1; row < rows.size(); ++row) {
      for (std::size_t column = 3; column < 48; ++column) {
        for (const SurveyChoice& choice : survey.choices) {
          if (rows[row][column] == choice.code) {
            rows[row][column] = " " + choice.label;
            break;
          }
        }
      }
    }
    SCOPED_TRACE(survey.language);
    expectBoth(responsesIn(textOf(rows)));
  }
}

TEST(SurveyResponses, AreReadWithTheItemsTextsAsHeader) {
  const Survey english = forceSurveys().front();
  Rows rows = redcapRows();
  rows[0][0] = "Participant code";
  std::size_t column = 3;
  for (const auto& matrix : english.matrices) {
    for (const auto& field : matrix.fields) rows[0][column++] = field.text;
  }
  expectBoth(responsesIn(textOf(rows)));
  rows[0][5] = "Something else";
  EXPECT_EQ(
      errorOf(rows),
      "responses.csv: header: found no column 'q01', and not each item's text once, wanted an export with raw data "
      "and field names");
}

TEST(SurveyResponses, OfLimeSurveyHaveTheQuestionBeforeTheItem) {
  Rows rows = redcapRows();
  rows[0][0] = "id";
  rows[0][1] = "code";
  for (std::size_t row = 1; row < rows.size(); ++row) rows[row][1] = std::exchange(rows[row][0], std::to_string(row));
  for (int item = 1; item <= 45; ++item) {
    std::string& name = rows[0][static_cast<std::size_t>(item) + 2];
    name = "m0" + std::to_string((item - 1) / 5 + 1) + "[" + name + "]";
  }
  expectBoth(responsesIn(textOf(rows)));
}

TEST(SurveyResponses, WhatIsLeftOutIsSaid) {
  Rows rows = redcapRows();
  rows.push_back(std::vector<std::string>(rows[0].size()));
  rows.back()[0] = "opened-only";
  const auto read = responsesIn(textOf(rows));
  expectBoth(read);
  EXPECT_EQ(read->notes,
            (std::vector<std::string>{
                "Ignored columns: redcap_survey_identifier, ngt_force_timestamp, ngt_force_complete.",
                "Rows without any answer, left out: 1.", "Marked as incomplete, and read all the same: 1."}));
}

TEST(SurveyResponses, WhatIsNoAnswerIsRefusedWithItsPlaceUnlessItIsNamed) {
  Rows rows = redcapRows();
  rows[2][8] = "-999";  // item 6, which amber-lynx does not answer
  EXPECT_EQ(
      errorOf(rows),
      "responses.csv: line 3, column 'q06': found '-999', wanted a code (1, 2, 3, 4, 5, 9), its label, or an empty "
      "cell");
  const auto read = responsesIn(textOf(rows), {{}, {"-999"}});
  expectBoth(read);
}

TEST(SurveyResponses, OfOneParticipantAreOneRow) {
  Rows rows = redcapRows();
  rows[2][0] = "velvet-otter";
  EXPECT_EQ(
      errorOf(rows),
      "responses.csv: line 3, column 'record_id': found 'velvet-otter', wanted one row for each participant; export "
      "one event and no repeats");
}

TEST(SurveyResponses, RecordIdsLeadToParticipants) {
  Rows rows = redcapRows();
  rows[1][0] = "1";
  rows[2][0] = "2";
  expectBoth(responsesIn(textOf(rows), {{{"1", "velvet-otter"}, {"2", "amber-lynx"}}, {}}));
  EXPECT_EQ(errorOf(rows, {{{"1", "velvet-otter"}}, {}}),
            "responses.csv: line 3, column 'record_id': found '2', wanted a record of the table of participants");
}

TEST(SurveyResponses, AnItemWithoutAColumnIsRefused) {
  Rows rows = redcapRows();
  for (auto& row : rows) row.erase(row.begin() + 9);  // q07
  EXPECT_EQ(errorOf(rows), "responses.csv: header: found no column 'q07', wanted a column for each of the items");
}

}  // namespace
}  // namespace tactus::questionnaires
