#include "app/editing/changed_parts.h"

#include <array>
#include <gtest/gtest.h>

#include "app/editing/membership_edits.h"
#include "app/editing/rule_edits.h"

#include "tests/app/editing/sample_models.h"

namespace tactus::editing {
namespace {

class ChangedPartsTest : public testing::Test {
 protected:
  const fuzzy::ForceModel model_ = support::s4AsPrinted();
};

TEST_F(ChangedPartsTest, TheRulesThatAreOtherOnes) {
  const auto edit = must(setConsequent(model_, "S4", std::array<std::size_t, 2>{3, 7}, "large"));
  const auto parts = changedParts(model_, edit.model);
  EXPECT_EQ(parts.expert, "S4");
  EXPECT_EQ(parts.rules, (std::vector<std::size_t>{3, 7}));
  EXPECT_FALSE(parts.term.has_value());
}

TEST_F(ChangedPartsTest, ARemovedRuleLeavesNoneButItsExpert) {
  const auto parts = changedParts(model_, must(removeRules(model_, "S4", std::array<std::size_t, 1>{3})).model);
  EXPECT_EQ(parts.expert, "S4");
  EXPECT_TRUE(parts.rules.empty());
}

TEST_F(ChangedPartsTest, ATermThatMoved) {
  auto after = model_;
  after.inputs[2].terms[1].points[1] += 1;
  const auto parts = changedParts(model_, after);
  EXPECT_TRUE(parts.expert.empty());
  ASSERT_TRUE(parts.term.has_value());
  EXPECT_EQ(*parts.term, (TermPlace{{"depth", ""}, model_.inputs[2].terms[1].id}));
}

TEST_F(ChangedPartsTest, NothingWhereNothingChanged) {
  const auto parts = changedParts(model_, model_);
  EXPECT_TRUE(parts.expert.empty() && parts.rules.empty() && !parts.term);
}

}  // namespace
}  // namespace tactus::editing
