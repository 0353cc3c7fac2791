#include "app/editing/lint_fixes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>

#include "app/editing/rule_edits.h"
#include "app/editing/term_edits.h"
#include "elicitation/rules/rule_lint.h"

#include "tests/app/editing/sample_models.h"

namespace tactus::editing {
namespace {

using analysis::Finding;
using Points = std::vector<double>;

std::vector<Fix> fixesOfFirst(const fuzzy::ForceModel& model, Finding::Kind kind, const std::string& expert = "S4") {
  const auto compiled = fuzzy::compile(model).value();
  const auto lint = analysis::lint(model, compiled);
  const auto found = std::find_if(lint.findings.begin(), lint.findings.end(),
                                  [&](const Finding& f) { return f.kind == kind && f.expert == expert; });
  EXPECT_NE(found, lint.findings.end());
  return found == lint.findings.end() ? std::vector<Fix>() : fixesFor(model, compiled, *found);
}

std::size_t count(const fuzzy::ForceModel& model, Finding::Kind kind) {
  const auto lint = analysis::lint(model, fuzzy::compile(model).value());
  return static_cast<std::size_t>(
      std::count_if(lint.findings.begin(), lint.findings.end(), [&](const Finding& f) { return f.kind == kind; }));
}

TEST(LintFixes, TheOropharynxHoleOfTableA2) {
  const auto model = support::s4AsPrinted();
  const auto fixes = fixesOfFirst(model, Finding::Kind::kHole);
  ASSERT_EQ(fixes.size(), 3);
  EXPECT_EQ(fixes[0].text, "Stretch nasopharynx over the gap");
  EXPECT_EQ(pointsOf(fixes[0].edit.model, "depth", "nasopharynx"), (Points{60, 80, 138, 162}));
  EXPECT_EQ(fixes[1].text, "Stretch laryngopharynx over the gap");
  EXPECT_EQ(fixes[1].edit.label, "Depth / laryngopharynx: stretched over 125 to 138 mm");
  // The third reading of the table: the laryngopharynx covers the oropharynx, 0.468 N over 125 to 185 mm at the
  // setting of Fig. 11.
  EXPECT_EQ(pointsOf(fixes[1].edit.model, "depth", "laryngopharynx"), (Points{105, 125, 185, 215}));
  EXPECT_NEAR(fixes[1].edit.compiled.evaluate(Points{1, 60, 130, 50}).force_n, 0.46797, 5e-6);
  EXPECT_GT(fixes[1].impact.closed, 0);
  EXPECT_EQ(count(fixes[1].edit.model, Finding::Kind::kHole), 0);
  EXPECT_EQ(fixes[2].text, "Accept the hole");
  EXPECT_EQ(fixes[2].edit.model.accepted_holes, std::vector<std::string>{"depth 125 to 138 mm"});
  EXPECT_EQ(fixes[2].impact.points, 0);
}

TEST(LintFixes, AHoleAtTheEndIsFilledUpToTheEnd) {
  // Labels shifted by one: nothing from 460 mm on.
  const auto fixes = fixesOfFirst(support::s4Shifted(), Finding::Kind::kHole);
  ASSERT_EQ(fixes.size(), 2);
  EXPECT_EQ(pointsOf(fixes[0].edit.model, "depth", "esophagus"), (Points{185, 215, 600, 600}));
}

TEST(LintFixes, OneOfSeveralExpertsGetsAListOfItsOwn) {
  auto model = support::s4AsPrinted();
  auto other = support::s4Shifted().experts[0];
  other.id = other.label = "S1";
  model.experts.push_back(other);
  const auto fixes = fixesOfFirst(model, Finding::Kind::kHole, "S4");
  ASSERT_EQ(fixes.size(), 3);
  EXPECT_EQ(fixes[0].edit.model.inputs, model.inputs);
  EXPECT_EQ(fixes[0].edit.model.experts[0].overrides.at(0).terms[1].points, (Points{60, 80, 138, 162}));
  EXPECT_TRUE(fixes[0].edit.model.experts[1].overrides.empty());
}

TEST(LintFixes, OfTwoRulesInConflictOneIsKept) {
  auto model = support::s4AsPrinted();
  model = must(addRule(model, "S4", {{{"lubrication", "well"}, {"depth", "nasal_cavity"}}, "large"})).model;
  const auto fixes = fixesOfFirst(model, Finding::Kind::kConflict);
  ASSERT_EQ(fixes.size(), 2);
  EXPECT_EQ(fixes[0].text, "Keep very_small");
  EXPECT_FALSE(fixes[0].edit.model.experts[0].rules[45].enabled);
  EXPECT_EQ(fixes[1].text, "Keep large");
  EXPECT_FALSE(fixes[1].edit.model.experts[0].rules[0].enabled);
  EXPECT_GT(fixes[0].impact.largest_n, 0.1);
  EXPECT_EQ(count(fixes[0].edit.model, Finding::Kind::kConflict), 0);
}

TEST(LintFixes, ARedundantRuleIsDisabledAtNoCost) {
  auto model = support::s4AsPrinted();
  const fuzzy::Rule narrow{{{"lubrication", "well"}, {"depth", "stomach"}, {"speed", "slow"}}, "very_small"};
  model = must(addRule(model, "S4", narrow)).model;
  const auto fixes = fixesOfFirst(model, Finding::Kind::kRedundantRule);
  ASSERT_EQ(fixes.size(), 1);
  EXPECT_FALSE(fixes[0].edit.model.experts[0].rules[45].enabled);
  EXPECT_EQ(fixes[0].impact.largest_n, 0);
}

TEST(LintFixes, AnUnusedTermIsRemoved) {
  const auto fixes = fixesOfFirst(support::s4AsPrinted(), Finding::Kind::kUnusedTerm);
  ASSERT_EQ(fixes.size(), 2);
  EXPECT_EQ(fixes[0].text, "Remove oropharynx");
  EXPECT_EQ(fixes[0].impact.largest_n, 0);
  EXPECT_EQ(fixes[1].text, "Remove oropharynx, its neighbors close up");
  EXPECT_EQ(count(fixes[1].edit.model, Finding::Kind::kHole), 0);
}

TEST(LintFixes, TheJumpOfTheMeanIsSettledAtTheHoleBehindIt) {
  auto model = support::s4AsPrinted();
  auto other = support::s4Shifted().experts[0];
  other.id = "S1";
  model.experts.push_back(other);
  const auto fixes = fixesOfFirst(model, Finding::Kind::kAbstentionJump);
  ASSERT_EQ(fixes.size(), 3);
  EXPECT_EQ(fixes[0].edit.label, fixesOfFirst(model, Finding::Kind::kHole)[0].edit.label);
}

TEST(LintFixes, FindingsOfTheRuleLintHaveTheSame) {
  const auto model = support::s4AsPrinted();
  const auto compiled = fuzzy::compile(model).value();
  std::size_t fixed = 0;
  for (const auto& finding : elicitation::ruleLint(model, compiled).findings) {
    const auto fixes = fixesFor(model, compiled, finding);
    if (finding.kind == elicitation::RuleFinding::Kind::kHole) {
      EXPECT_EQ(fixes.size(), 3);
      ++fixed;
    }
    if (finding.kind == elicitation::RuleFinding::Kind::kRegionWithoutRule) {
      ASSERT_EQ(fixes.size(), 5);
      EXPECT_EQ(fixes[0].text, "Remove oropharynx");
      EXPECT_EQ(fixes[4].text, "Accept the hole");
    }
    if (finding.kind == elicitation::RuleFinding::Kind::kAgainstDeclaration) {
      EXPECT_TRUE(fixes.empty());
    }
  }
  EXPECT_EQ(fixed, 2);  // of S4, and of all
}

using Rules = elicitation::RuleFinding;

std::vector<Rules> stepsOf(const fuzzy::ForceModel& model) {
  std::vector<Rules> out;
  for (auto& finding : elicitation::ruleLint(model, fuzzy::compile(model).value()).findings) {
    if (finding.kind == Rules::Kind::kForceStep) out.push_back(finding);
  }
  return out;
}

// The nasopharynx ends at 105 mm with a vertical edge, where the laryngopharynx has hardly begun.
TEST(LintFixes, AVerticalEdgeIsWidened) {
  auto model = support::s4FiveRegions();
  EXPECT_TRUE(stepsOf(model).empty());
  auto& terms = model.inputs[2].terms;
  ASSERT_EQ(terms[1].id, "nasopharynx");
  terms[1].points = {60, 80, 105, 105};
  const auto compiled = fuzzy::compile(model).value();
  const auto steps = stepsOf(model);
  ASSERT_EQ(steps.size(), 2);  // the mean of one expert is that expert
  for (const auto& step : steps) {
    EXPECT_NEAR(step.from[2], 105, 1);
    EXPECT_NEAR(step.to[2], 105, 1);
    ASSERT_TRUE(step.newtons.has_value());
    const auto force = [&](const Points& at) { return compiled.evaluate(at).force_n; };
    EXPECT_NEAR(*step.newtons, std::abs(force(step.to) - force(step.from)), 1e-12);
    EXPECT_NE(step.text.find("the force steps from "), std::string::npos) << step.text;
    const auto fixes = fixesFor(model, compiled, step);
    ASSERT_FALSE(fixes.empty());
    EXPECT_EQ(fixes[0].text, "Widen to 5 mm");
    EXPECT_EQ(pointsOf(fixes[0].edit.model, "depth", "nasopharynx"), (Points{60, 80, 102.5, 107.5}));
    EXPECT_EQ(pointsOf(fixes[0].edit.model, "depth", "laryngopharynx"), (Points{102.5, 125, 185, 215}));
    EXPECT_EQ(fixes[0].edit.label, "Depth / nasopharynx, laryngopharynx: step widened to 5 mm around 105 mm");
    // The last of them leaves none.
    EXPECT_TRUE(stepsOf(fixes.back().edit.model).empty()) << fixes.back().text;
  }
}

TEST(LintFixes, RegionsThatOnlyMeetAreMadeToOverlap) {
  auto model = support::s4FiveRegions();
  auto& terms = model.inputs[2].terms;
  ASSERT_EQ(terms[2].id, "laryngopharynx");
  terms[1].points = {60, 80, 85, 105};
  terms[2].points[0] = 105 - 1e-6;
  const auto compiled = fuzzy::compile(model).value();
  const auto steps = stepsOf(model);
  ASSERT_FALSE(steps.empty());
  const auto fixes = fixesFor(model, compiled, steps[0]);
  ASSERT_FALSE(fixes.empty());
  const auto first = pointsOf(fixes[0].edit.model, "depth", "nasopharynx");
  const auto second = pointsOf(fixes[0].edit.model, "depth", "laryngopharynx");
  EXPECT_NEAR(first[3] - second[0], 5, 1e-5);
  EXPECT_EQ(first[2], 85);
  EXPECT_EQ(second[1], 125);
}

}  // namespace
}  // namespace tactus::editing
