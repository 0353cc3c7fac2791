#include "questionnaires/form_file.h"

#include <gtest/gtest.h>

#include "tests/questionnaires/paper_table.h"

namespace tactus::questionnaires {
namespace {

using Conditions = std::vector<study::ItemCondition>;

TEST(NgtForceForm, HasTheWordingOfTableA1) {
  const auto form = ngtForceForm();
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
  const auto form = ngtForceForm();
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
  const auto form = ngtForceForm();
  const std::vector<study::AnswerWord> wanted = {{"Very Small", "very_small"},
                                                 {"Small", "small"},
                                                 {"Medium", "medium"},
                                                 {"Large", "large"},
                                                 {"Very Large", "very_large"}};
  EXPECT_EQ(form.answers, wanted);
  EXPECT_EQ(form.id, "ngt-force-v1");
  EXPECT_EQ(form.depth_terms, "form_a1");
}

std::string formWith(const std::string& items) {
  return R"({"format": "tactus-form", "id": "f", "version": 1, "title": "t", "source": "s", "depth_terms": "form_a1",
             "answers": ["Small"], "items": [)" +
         items + "]}";
}

std::string refusal(const std::string& text) {
  const auto form = parseForm(text, "f.json", ngtAliases());
  return form ? "" : form.error().message();
}

TEST(FormFiles, BrokenOnesAreRefusedInOneSentence) {
  EXPECT_EQ(refusal("{"), "f.json: line 1, column 2: found the end of the text, wanted the rest of the JSON");
  EXPECT_EQ(refusal("[]"), "f.json: found JSON that is not an object, wanted an object");
  EXPECT_EQ(refusal(R"({"format": "other"})"), "f.json: /format: found the string 'other', wanted 'tactus-form'");
  EXPECT_EQ(refusal(R"({"format": "tactus-form"})"),
            "f.json: found no key 'id', wanted a key 'id' with a text that is not empty");
  EXPECT_EQ(refusal(formWith("")), "f.json: /items: found no items, wanted at least one item");
  EXPECT_EQ(refusal(formWith(R"({"number": 0, "text": "x"})")),
            "f.json: /items/0/number: found the number 0, wanted a whole number from 1 to 1000000");
  const std::string slow = R"({"number": 1, "text": "IF Speed IS Slow THEN Force IS"})";
  EXPECT_EQ(refusal(formWith(slow + "," + slow)), "f.json: /items/1/number: found 1 again, wanted each number once");
  EXPECT_EQ(refusal(formWith(slow + R"(, {"number": 2, "text": "IF Speed IS Slow, THEN Force Change IS:"})")),
            "f.json: /items/1/text: found the condition of item 1, wanted another condition for each item");
  EXPECT_EQ(refusal(formWith(R"({"number": 1, "text": "IF Speed IS Slow THEN Force IS Small"})")),
            "f.json: /items/0/text: found a sentence with its answer, wanted a sentence that ends with IS");
  EXPECT_EQ(refusal(formWith(R"({"number": 1, "text": "IF Speed IS Idle THEN Force IS"})")),
            "f.json: /items/0/text: sentence 'IF Speed IS Idle THEN Force IS': found 'Idle', wanted a term of 'speed': "
            "slow, medium, fast");
}

}  // namespace
}  // namespace tactus::questionnaires
