#include "app/workbench/tune/rules/rule_controller.h"

#include <QSignalSpy>
#include <QTest>
#include <gtest/gtest.h>

#include "app/editing/edit.h"
#include "app/editing/term_edits.h"
#include "app/workbench/tune/history/compare_controller.h"

#include "tests/gui/s4_rules.h"

namespace tactus::workbench {
namespace {

using RuleControllerTest = tests::S4Rules;

TEST_F(RuleControllerTest, TheColumnsAreTheWayOfTheTube) {
  EXPECT_EQ(rules.region(), "depth");
  ASSERT_EQ(rules.grids().size(), 3U);
  EXPECT_EQ(rules.grids()[2].id.condition, "speed");
  EXPECT_EQ(rules.words().size(), 5U);
}

TEST_F(RuleControllerTest, AnAnswerChangesTheRuleOfTheCell) {
  rules.select(RuleCell{0, 2, 4});  // well and esophagus: medium, rule 4
  rules.answer(4);
  EXPECT_EQ(rule(3).then, "very_large");
  EXPECT_EQ(rules.cell({0, 2, 4}).then, "very_large");
  EXPECT_EQ(edits.undoText(), QStringLiteral("S4: IF Tube lubrication is well AND Depth is esophagus: medium to "
                                             "very_large"));
  edits.undo();
  EXPECT_EQ(rules.cell({0, 2, 4}).then, "medium");
  EXPECT_TRUE(editing::sameBits(edits.model(), start));
}

TEST_F(RuleControllerTest, AnEmptyCellThatIsEmptiedIsNoEdit) {
  rules.select(RuleCell{0, 0, 2});
  rules.answer(std::nullopt);
  EXPECT_FALSE(edits.canUndo());
  rules.answer(0);
  EXPECT_EQ(rules.expert().rules.size(), 46U);
  rules.answer(std::nullopt);
  EXPECT_EQ(rules.expert().rules.size(), 45U);
}

TEST_F(RuleControllerTest, TheSelectionGoesOnAsCellsAreFilledIn) {
  rules.select(RuleCell{0, 0, 5});
  rules.goOn();
  EXPECT_EQ(rules.selected(), (RuleCell{0, 1, 0}));
  rules.select(RuleCell{1, 2, 5});
  rules.goOn();
  EXPECT_EQ(rules.selected(), (RuleCell{2, 0, 0}));
  rules.select(RuleCell{2, 2, 5});
  rules.goOn();
  EXPECT_EQ(rules.selected(), (RuleCell{2, 2, 5}));
}

TEST_F(RuleControllerTest, ArrowsMoveFromGridToGridAndStopAtTheEdges) {
  rules.select(RuleCell{0, 2, 3});
  rules.step(0, 1);
  EXPECT_EQ(rules.selected(), (RuleCell{1, 0, 3}));
  rules.step(0, -1);
  EXPECT_EQ(rules.selected(), (RuleCell{0, 2, 3}));
  rules.stepToEnd(true);
  rules.step(1, 0);
  EXPECT_EQ(rules.selected(), (RuleCell{0, 2, 5}));
  rules.stepGrid(5);
  EXPECT_EQ(rules.selected(), (RuleCell{2, 2, 5}));
  rules.step(0, 1);
  EXPECT_EQ(rules.selected(), (RuleCell{2, 2, 5}));
  rules.stepGrid(-5);
  rules.stepToEnd(false);
  rules.step(-1, 0);
  EXPECT_EQ(rules.selected(), (RuleCell{0, 2, 0}));
}

TEST_F(RuleControllerTest, StrengthsAreThoseAtThePlaceThatIsRead) {
  scene.setValue(0, 0.7);  // medium 0.5, well 0.5
  scene.setValue(1, 0);
  scene.setValue(2, 30);  // nasal cavity
  scene.setValue(3, 0);
  const auto strength = [&](const RuleCell& place) { return rules.strength(*rules.cell(place).rule); };
  EXPECT_NEAR(strength({0, 1, 0}), 0.5, 1e-12);
  EXPECT_NEAR(strength({0, 2, 0}), 0.5, 1e-12);
  EXPECT_EQ(strength({0, 0, 0}), 0);
  EXPECT_EQ(strength({0, 2, 1}), 0);
  EXPECT_EQ(rules.membership("depth", 0), 1);
  EXPECT_EQ(rules.membership("depth", 1), 0);
  rules.setWeight({*rules.cell({0, 2, 0}).rule}, 0.5);
  EXPECT_NEAR(strength({0, 2, 0}), 0.25, 1e-12);
}

TEST_F(RuleControllerTest, StepsOfAWeightAreOneEntry) {
  for (const double weight : {0.95, 0.9, 0.85}) rules.weigh(3, weight);
  rules.endWeighing();
  EXPECT_EQ(rule(3).weight, 0.85);
  EXPECT_EQ(edits.history().line().size(), 2U);
  rules.weigh(3, 0.8);
  edits.undo();  // in the middle of the steps
  EXPECT_EQ(rule(3).weight, 0.85);
  edits.undo();
  EXPECT_TRUE(editing::sameBits(edits.model(), start));
  rules.weigh(3, 0.5);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !edits.inGesture(); }, 10'000)) << "a rest ends the steps";
}

TEST_F(RuleControllerTest, TheSelectionSurvivesASplitAndItsUndo) {
  rules.select(RuleCell{1, 1, 5});  // stomach
  editing::SplitOptions options;
  options.cuts = {290, 365};
  ASSERT_TRUE(edits.apply(editing::splitTerm(edits.model(), {{"depth", ""}, "esophagus"}, options)));
  EXPECT_EQ(rules.selected(), (RuleCell{1, 1, 7}));
  EXPECT_EQ(rules.grids()[0].cells.columns.size(), 8U);
  edits.undo();
  EXPECT_EQ(rules.selected(), (RuleCell{1, 1, 5}));
}

TEST_F(RuleControllerTest, AnotherModelHasOtherExpertsAndInputs) {
  QSignalSpy other(&rules, &RuleController::expertChanged);
  models.open(folder.write(tests::twoExperts(), QStringLiteral("two.tactus.json")));
  EXPECT_EQ(other.size(), 1);
  EXPECT_EQ(rules.expert().id, "A");
  ASSERT_EQ(rules.grids().size(), 1U);
  EXPECT_FALSE(rules.selected());
  EXPECT_EQ(rules.grids()[0].cells.rows, (std::vector<std::string>{"slow", "fast"}));
  rules.setExpert("B");
  EXPECT_EQ(rules.grids()[0].cells.rows, (std::vector<std::string>{"any"})) << "B has terms of its own";
  rules.setRegion("speed");
  EXPECT_EQ(rules.grids()[0].cells.columns, (std::vector<std::string>{"any"}));
}

TEST_F(RuleControllerTest, RefusalsLeaveTheModelAsItWas) {
  QSignalSpy refused(&edits, &EditController::refused);
  EXPECT_FALSE(rules.add(rule(2)));
  EXPECT_FALSE(rules.add({{}, "small"}));
  EXPECT_FALSE(rules.replace(7, rule(2)));
  EXPECT_EQ(refused.size(), 0) << "the form says it";
  rules.setConsequent({99}, "small");
  EXPECT_EQ(refused.size(), 1);
  EXPECT_TRUE(editing::sameBits(edits.model(), start));
}

TEST_F(RuleControllerTest, WhatSpeaksAgainstACellIsNamed) {
  ASSERT_TRUE(rules.add({{{"lubrication", "well"}, {"depth", "esophagus"}}, "very_large"}));
  EXPECT_TRUE(rules.cell({0, 2, 4}).conflict);
  EXPECT_EQ(rules.otherAnswers({0, 2, 4}), QStringList(QStringLiteral("very_large")));
  rules.enable({45}, false);
  EXPECT_FALSE(rules.cell({0, 2, 4}).conflict);
}

TEST_F(RuleControllerTest, WhatIsNotThereIsNotChosen) {
  const QSignalSpy other(&rules, &RuleController::rulesChanged);
  rules.setExpert("nobody");
  rules.setRegion("nowhere");
  EXPECT_EQ(rules.expert().id, "S4");
  EXPECT_EQ(rules.region(), "depth");
  EXPECT_EQ(other.size(), 0);
  for (const RuleCell& cell : {RuleCell{3, 0, 0}, RuleCell{0, 3, 0}, RuleCell{0, 0, 6}}) {
    rules.select(cell);
    EXPECT_FALSE(rules.selected());
  }
  rules.select(RuleCell{0, 0, 0});
  rules.answer(5);
  EXPECT_FALSE(edits.canUndo());
}

TEST_F(RuleControllerTest, StrengthsAreThoseOfTheOpenModelWhileAnotherIsShown) {
  CompareController compare(models, edits);
  scene.setValue(0, 0.7);  // medium 0.5, well 0.5
  scene.setValue(1, 0);
  scene.setValue(2, 30);  // nasal cavity
  scene.setValue(3, 0);
  const RuleCell medium{0, 1, 0};
  rules.remove({0, 1});  // of the others each has another number now
  const std::size_t number = *rules.cell(medium).rule;
  rules.setWeight({number}, 0.5);
  EXPECT_NEAR(rules.strength(number), 0.25, 1e-12);
  compare.choose(CompareSide::kB, {CompareChoice::Kind::kState, 0, {}});
  compare.show(CompareSide::kB);
  ASSERT_TRUE(compare.showsAnother());
  EXPECT_NEAR(rules.strength(number), 0.25, 1e-12);
  scene.setValue(0, 0.65);  // medium 0.75
  EXPECT_NEAR(rules.strength(number), 0.375, 1e-12);
  EXPECT_EQ(rules.membership("depth", 0), 1);
}

}  // namespace
}  // namespace tactus::workbench
