#include "app/workbench/model/selection.h"

#include <QSignalSpy>
#include <gtest/gtest.h>

#include "app/editing/rule_edits.h"

#include "tests/gui/s4_rules.h"

namespace tactus::workbench {
namespace {

using SelectionTest = tests::S4Rules;
using Rules = std::vector<std::size_t>;

TEST_F(SelectionTest, ARuleThatWasPointedAtBringsItsCellAlong) {
  QSignalSpy pointed(&selection, &Selection::rulesPointed);
  QSignalSpy cell(&rules, &RuleController::selectionChanged);
  selection.pointAtRules("S4", {3});  // well and esophagus
  EXPECT_EQ(rules.selected(), (RuleCell{0, 2, 4}));
  EXPECT_EQ(selection.rule(), 3U);
  EXPECT_EQ(pointed.count(), 1);
  EXPECT_EQ(cell.count(), 1);
}

TEST_F(SelectionTest, AClickOnACellSelectsItsRuleAndAnEmptyCellNone) {
  rules.select(RuleCell{0, 2, 4});
  EXPECT_EQ(selection.rules(), Rules{3});
  rules.select(RuleCell{0, 0, 2});
  EXPECT_TRUE(selection.rules().empty());
  rules.answer(1);
  ASSERT_TRUE(selection.rule().has_value());
  EXPECT_EQ(rule(*selection.rule()).then, "small");
}

TEST_F(SelectionTest, AnEmptyCellIsSelectedLikeARule) {
  // S4 has no rule for the oropharynx.
  const std::vector<fuzzy::Condition> gap{{"lubrication", "poor"}, {"depth", "oropharynx"}};
  rules.select(RuleCell{0, 0, 2});
  EXPECT_EQ(selection.gap(), gap);
  rules.select(RuleCell{0, 2, 4});
  EXPECT_TRUE(selection.gap().empty());
  // Elsewhere in the program it brings its cell along.
  selection.selectGap(gap);
  EXPECT_EQ(rules.selected(), (RuleCell{0, 0, 2}));
  EXPECT_TRUE(selection.rules().empty());
  // The operating point goes there as to a rule: to the near end of the core, 0 to 0.2.
  scene.setValue(0, 1);
  rules.goWhereItActs();
  EXPECT_EQ(scene.value(0), 0.2);
  // An edit that gives it a rule makes it that rule.
  rules.answer(1);
  EXPECT_TRUE(selection.gap().empty());
  ASSERT_TRUE(selection.rule().has_value());
  EXPECT_EQ(rule(*selection.rule()).conditions, gap);
  selection.selectGap({{"lubrication", "dry"}, {"depth", "oropharynx"}});
  EXPECT_TRUE(selection.gap().empty());
  EXPECT_TRUE(selection.rule().has_value());
}

TEST_F(SelectionTest, RulesStaySelectedWhereAnEditMovesOrChangesThem) {
  selection.selectRules({3, 7});
  edits.apply(editing::setConsequent(edits.model(), "S4", 3, "very_large"));
  EXPECT_EQ(selection.rules(), (Rules{3, 7}));
  edits.apply(editing::removeRules(edits.model(), "S4", Rules{0}));
  EXPECT_EQ(selection.rules(), (Rules{2, 6}));
  edits.apply(editing::removeRules(edits.model(), "S4", Rules{2}));
  EXPECT_EQ(selection.rules(), Rules{5});
  edits.undo();
  edits.undo();
  EXPECT_EQ(selection.rules(), Rules{7});
}

TEST_F(SelectionTest, WhatTheModelDoesNotHaveIsIgnored) {
  selection.selectRules({3, 45, 3});
  EXPECT_EQ(selection.rules(), Rules{3});
  QSignalSpy pointed(&selection, &Selection::rulesPointed);
  selection.pointAtRules("S9", {1});
  selection.pointAtTerm({{"depth", ""}, "elbow"});
  EXPECT_EQ(pointed.count(), 0);
  EXPECT_EQ(selection.rules(), Rules{3});
  EXPECT_FALSE(selection.term().has_value());
  selection.pointAtTerm({{"depth", ""}, "esophagus"});
  EXPECT_EQ(selection.term()->term, "esophagus");
}

TEST_F(SelectionTest, GoWhereItActsMovesOnlyWhatTheRuleNamesAndNoFurtherThanItMust) {
  const double flexion = scene.value(1);
  const double speed = scene.value(3);
  scene.setValue(0, 0);
  scene.setValue(2, 0);
  selection.selectRules({3});
  rules.goWhereItActs();
  EXPECT_EQ(rules.strength(3), 1);
  EXPECT_EQ(scene.value(1), flexion);
  EXPECT_EQ(scene.value(3), speed);
  // The near end of the esophagus' core, from a depth before it.
  const fuzzy::Term& esophagus = edits.model().inputs[2].terms[4];
  ASSERT_EQ(esophagus.id, "esophagus");
  EXPECT_EQ(scene.value(2), esophagus.points[1]);
}

TEST_F(SelectionTest, SeveralRulesAreChangedInOneStep) {
  rules.setConsequent({0, 1, 4}, "large");
  for (const std::size_t r : {0, 1, 4}) EXPECT_EQ(rule(r).then, "large");
  edits.undo();
  EXPECT_EQ(edits.model().experts[0].rules, start.experts[0].rules);
}

TEST_F(SelectionTest, ABlockOfTextIsCopiedAndPasted) {
  selection.selectRules({0, 3});
  const QString lines = rules.copied();
  EXPECT_EQ(lines.count(QLatin1Char('\n')), 2);
  rules.remove({0, 3});
  EXPECT_EQ(count(), 43U);
  rules.paste(lines);
  EXPECT_EQ(count(), 45U);
  EXPECT_EQ(selection.rules(), (Rules{43, 44}));
  edits.undo();
  EXPECT_EQ(count(), 43U);
}

TEST_F(SelectionTest, ALineThatIsNoRuleIsNamedAndNothingIsChanged) {
  QSignalSpy refused(&edits, &EditController::refused);
  rules.paste(QStringLiteral("IF Speed is fast THEN small\nIF Speed is fats THEN small"));
  EXPECT_FALSE(edits.canUndo());
  ASSERT_EQ(refused.count(), 1);
  EXPECT_EQ(refused.front().front().toString(),
            QStringLiteral("Nothing was pasted: line 2: found 'fats', wanted a term of Speed (fast?)"));
}

}  // namespace
}  // namespace tactus::workbench
