#include <gtest/gtest.h>

#include "core/analysis/force_difference.h"

#include "tests/support/ngt_model.h"

namespace tactus::analysis {
namespace {

using ChangeKind = ModelChange::Kind;

TEST(ModelDifference, EqualModelsDoNotDiffer) {
  auto model = support::s4Shifted();
  auto other = model;
  other.name = "another name";
  other.inputs[0].label = "another label";
  other.generator = "another program";
  EXPECT_TRUE(modelChanges(model, other).empty());
}

TEST(ModelDifference, EachChangeIsNamedOnce) {
  const auto first = support::s4Shifted();
  auto second = first;
  second.inputs[3].terms[0].points[3] = 55;
  second.experts[0].rules[0].then = "large";
  second.experts[0].rules[1].enabled = false;
  second.experts[0].rules.pop_back();
  second.experts[0].weight = 2;
  second.default_force_n = 0.1;
  second.renderer.emplace().stiffness_n_mm = 0.5;
  second.experts.push_back({"S5", "S5", 1, {}, {}});
  second.contracts.push_back({"safe", fuzzy::Contract::Kind::kNeverAbove, "", "", "", 0, 1, false, {}});
  second.events.push_back({"nasopharynx", 0.6});
  const auto changes = modelChanges(first, second);
  ASSERT_EQ(changes.size(), 10U);
  const auto find = [&changes](const std::string& start) -> ModelChange {
    for (const ModelChange& change : changes) {
      if (change.place.starts_with(start)) return change;
    }
    ADD_FAILURE() << start;
    return {};
  };
  EXPECT_EQ(find("term 'slow' of 'speed'").kind, ChangeKind::kChanged);
  EXPECT_EQ(find("expert 'S4'"), (ModelChange{ChangeKind::kChanged, "expert 'S4'", "weight 1", "weight 2"}));
  EXPECT_EQ(find("expert 'S5'").kind, ChangeKind::kAdded);
  EXPECT_EQ(find("default force"), (ModelChange{ChangeKind::kChanged, "default force", "0", "0.1"}));
  EXPECT_EQ(find("contract"), (ModelChange{ChangeKind::kAdded, "contract 'safe'", "", "the force is never above 1 N"}));
  EXPECT_EQ(find("puncture"), (ModelChange{ChangeKind::kAdded, "puncture at 'nasopharynx'", "", "share 0.6"}));
  EXPECT_EQ(find("renderer"), (ModelChange{ChangeKind::kChanged, "renderer, stiffness_n_mm", "0.25", "0.5"}));
  int rules = 0;
  int removed = 0;
  for (const ModelChange& change : changes) {
    if (!change.place.starts_with("rule of 'S4': ")) continue;
    ++rules;
    removed += change.kind == ChangeKind::kRemoved ? 1 : 0;
  }
  EXPECT_EQ(rules, 3);
  EXPECT_EQ(removed, 1);
}

TEST(ModelDifference, TheOrderOfRulesAndConditionsDoesNotMatter) {
  const auto first = support::s4Shifted();
  auto second = first;
  std::swap(second.experts[0].rules[0], second.experts[0].rules[5]);
  std::swap(second.experts[0].rules[1].conditions[0], second.experts[0].rules[1].conditions[1]);
  EXPECT_TRUE(modelChanges(first, second).empty());
}

}  // namespace
}  // namespace tactus::analysis
