#include <gtest/gtest.h>

#include "tests/questionnaires/paper_table.h"
#include "tests/support/default_procedure.h"

namespace tactus::questionnaires {
namespace {

using Conditions = std::vector<study::ItemCondition>;

TEST(NgtForceForm, HasTheWordingOfTableA1) {
  const auto form = support::ngtForceForm();
  const auto printed = paperTable("table_a1.txt");
  ASSERT_EQ(printed.size(), 45U);
  ASSERT_EQ(form.items.size(), 45U);
  for (std::size_t i = 0; i < 45; ++i) {
    EXPECT_EQ(form.items[i].number, printed[i].first);
    EXPECT_EQ(form.items[i].text, printed[i].second);
  }
}

// Nine conditions in the paper's order, each in its five regions: 45 different items.
TEST(NgtForceForm, AsksEachConditionInEachRegionOnce) {
  const Conditions asked = {{"lubrication", "poor"},   {"lubrication", "medium"},  {"lubrication", "well"},
                            {"neck_flexion", "small"}, {"neck_flexion", "medium"}, {"neck_flexion", "large"},
                            {"speed", "slow"},         {"speed", "medium"},        {"speed", "fast"}};
  const auto form = support::ngtForceForm();
  std::size_t item = 0;
  for (const auto& condition : asked) {
    for (const auto* region : {"nasal_cavity", "nasopharynx", "oropharynx", "laryngopharynx", "esophagus"}) {
      ASSERT_LT(item, form.items.size());
      const study::ItemCondition depth{"depth", region};
      // Conditions stand in the order of the inputs, where speed is the last.
      const Conditions wanted =
          condition.input == "speed" ? Conditions{depth, condition} : Conditions{condition, depth};
      EXPECT_EQ(form.items[item].conditions, wanted) << "item " << form.items[item].number;
      ++item;
    }
  }
  EXPECT_EQ(item, form.items.size());
}

TEST(NgtForceForm, OffersTheFiveWords) {
  const auto form = support::ngtForceForm();
  const std::vector<study::AnswerWord> wanted = {{"Very Small", "very_small"},
                                                 {"Small", "small"},
                                                 {"Medium", "medium"},
                                                 {"Large", "large"},
                                                 {"Very Large", "very_large"}};
  EXPECT_EQ(form.answers, wanted);
  EXPECT_EQ(form.id, "ngt-force-v1");
  EXPECT_EQ(form.depth_terms, "form_a1");
}

}  // namespace
}  // namespace tactus::questionnaires
