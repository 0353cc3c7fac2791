#include "questionnaires/scale_summary.h"

#include <cmath>
#include <gtest/gtest.h>

namespace tactus::questionnaires {
namespace {

/// Answers to item 3 of the usability form, one person each.
std::vector<study::AnswerRecord> answers(const std::vector<int>& points) {
  study::RecordIds ids(1);
  std::vector<study::AnswerRecord> records;
  for (const int point : points) {
    study::AnswerRecord record;
    record.entry.id = ids.next();
    record.form = "usability-v1";
    record.item = 3;
    record.status = study::Answer::Status::kAnswered;
    record.value = std::to_string(point);
    records.push_back(record);
  }
  return records;
}

// Nine answers that give the mean and deviation of Table 3, item 3: sum 40, squares 184; (184 - 40²/9) / 8 = 0.7778.
TEST(ScaleSummary, MeanDeviationAndRange) {
  const auto rows = summarize(usabilityForm(), answers({3, 4, 4, 4, 4, 5, 5, 5, 6}));
  ASSERT_EQ(rows.size(), 6U);
  EXPECT_EQ(rows[2].item, 3);
  EXPECT_EQ(rows[2].n, 9U);
  EXPECT_NEAR(rows[2].mean, 40.0 / 9, 1e-14);
  EXPECT_NEAR(rows[2].sd, std::sqrt((184 - 1600.0 / 9) / 8), 1e-14);
  EXPECT_EQ(rows[2].min, 3);
  EXPECT_EQ(rows[2].max, 6);
  EXPECT_EQ(rows[0].n, 0U);
  EXPECT_EQ(rows[0].mean, 0);
}

TEST(ScaleSummary, OnlyTheLatestAnswersCount) {
  auto records = answers({2, 7, 5});
  records[1].entry.supersedes = records[0].entry.id;  // 2 became 7
  records[2].status = study::Answer::Status::kCantTell;
  records[2].value.clear();
  const auto rows = summarize(usabilityForm(), records);
  EXPECT_EQ(rows[2].n, 1U);
  EXPECT_EQ(rows[2].mean, 7);
  EXPECT_EQ(rows[2].sd, 0);
}

TEST(ScaleSummary, OtherFormsAndVersionsDoNotCount) {
  auto records = answers({2, 7});
  records[0].form = "ngt-force-v1";
  records[1].form_version = 2;
  EXPECT_EQ(summarize(usabilityForm(), records)[2].n, 0U);
}

TEST(PublishedUsability, IsTable3) {
  const auto rows = publishedUsability();
  ASSERT_EQ(rows.size(), 6U);
  EXPECT_EQ(rows[0], (ScaleSummary{1, 9, 5.78, 0.83, 5, 7}));
  EXPECT_EQ(rows[4], (ScaleSummary{5, 9, 4.89, 1.54, 3, 7}));
}

// Of the printed rows only item 3 is impossible, and only because of its maximum.
TEST(PublishedUsability, OneMaximumIsImpossible) {
  for (auto row : publishedUsability()) {
    EXPECT_EQ(isPossible(row, row.n, 7), row.item != 3) << "item " << row.item;
    if (row.item != 3) continue;
    row.max = 6;
    EXPECT_TRUE(isPossible(row, row.n, 7));
  }
}

TEST(PublishedUsability, ImpossibleRowsAreFound) {
  EXPECT_TRUE(isPossible({1, 2, 4.5, 0.71, 4, 5}, 2, 7));   // 4 and 5: the deviation is 1 / sqrt 2
  EXPECT_FALSE(isPossible({1, 2, 4.5, 0.5, 4, 5}, 2, 7));   // with n in the denominator it would be 0.5
  EXPECT_FALSE(isPossible({1, 2, 4.5, 0.71, 4, 8}, 2, 7));  // beyond the scale
  EXPECT_FALSE(isPossible({1, 1, 4, 0, 4, 4}, 1, 7));       // one answer has no deviation
}

}  // namespace
}  // namespace tactus::questionnaires
