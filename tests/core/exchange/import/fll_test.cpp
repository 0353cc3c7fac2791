// FLL of fuzzylite 5 to 7.
#include "tests/core/exchange/import/imported.h"

namespace tactus::exchange {
namespace {

TEST(Fll, AModelIsReadWithItsForces) {
  const auto from = imported(fll("  rule: if x is low and z is low then y is small\n"
                                 "  rule: if x is high then y is large with 0.5\n"),
                             "pair.fll");
  ASSERT_TRUE(from.model) << from.refusal;
  EXPECT_EQ(from.warnings, std::vector<std::string>{});
  EXPECT_EQ(from.model->name, "pair");
  EXPECT_EQ(from.model->experts.front().id, "pair");
  EXPECT_EQ(from.model->inputs[0].terms[1].points, (std::vector<double>{2, 4, 10, 10}));
  EXPECT_EQ(force(from, {0, 0}), 2);
  EXPECT_EQ(force(from, {10, 0}), 6);
  // At x = 3, z = 3.5: low is 0.5 and 0.25, high 0.5 with half of the weight: strengths 0.25 and 0.25.
  EXPECT_NEAR(force(from, {3, 3.5}), 4, 1e-14);
  EXPECT_FALSE(fires(from, {0, 10}));
}

TEST(Fll, ClipAndItsOlderWords) {
  // Clipped at 0.5, a triangle of width 2 has the area 0.75; at 1 it has 1.
  const std::string rules = "  rule: if x is low then y is small\n  rule: if z is low then y is large\n";
  const auto newer = imported(fll(rules, {}, "  implication: Minimum\n  activation: General\n"), "a.fll");
  EXPECT_NEAR(force(newer, {3, 0}), (2 * 0.75 + 6 * 1) / 1.75, 1e-14);
  std::string older = fll(rules, {}, "  activation: Minimum\n");
  older.replace(older.find("aggregation:"), 12, "accumulation:");
  EXPECT_NEAR(force(imported(older, "a.fll"), {3, 0}), (2 * 0.75 + 6 * 1) / 1.75, 1e-14);
}

TEST(Fll, OddFormsOfTheSameFile) {
  const std::string plain =
      fll("  rule: if x is low then y is small\n  rule: if x is high and z is high then y is large\n");
  std::string windows;
  for (const char c : plain) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  std::string old_mac;
  for (const char c : plain) old_mac += c == '\n' ? '\r' : c;
  std::string unnamed = plain;
  unnamed.replace(unnamed.find("RuleBlock: rules"), 16, "RuleBlock:");
  std::string described = plain;
  described.insert(described.find("  enabled"), "  description: how far: the pump # and so on\n");
  std::string named = plain;
  named.replace(0, 12, "Engine: Two words here");
  std::string tabs = plain;
  for (char& c : tabs) c = c == ' ' ? '\t' : c;
  for (const std::string& text : {plain.substr(0, plain.size() - 1), windows, old_mac, "\xEF\xBB\xBF" + plain, unnamed,
                                  described, named, tabs, "# a comment\n\n" + plain}) {
    const auto from = imported(text, "pair.txt");
    EXPECT_NEAR(force(from, {3.5, 5}), (2 * 0.25 + 6 * 0.75), 1e-14) << text;
    EXPECT_TRUE(from.warnings.empty());
  }
}

TEST(Fll, ConsequentsJoinedByAndAreTwoRules) {
  const auto from = imported(fll("  rule: if x is low then y is small and y is large\n"), "a.fll");
  ASSERT_TRUE(from.model) << from.refusal;
  EXPECT_EQ(from.model->experts.front().rules.size(), 2U);
  EXPECT_NEAR(force(from, {0, 0}), 4, 1e-14);
}

TEST(Fll, BlocksWithDifferentNormsAreReadAsFarAsRulesUseThem) {
  // No rule of the second block has an AND, so its product norm changes nothing.
  const auto from = imported(fll("  rule: if x is low and z is low then y is small\n"
                                 "RuleBlock: second\n  conjunction: AlgebraicProduct\n  implication: AlgebraicProduct\n"
                                 "  rule: if x is high then y is large\n"),
                             "a.fll");
  EXPECT_NEAR(force(from, {3, 0}), 4, 1e-14);
}

TEST(Fll, ADisabledBlockIsLeftOut) {
  const auto from = imported(fll("  rule: if x is low then y is small\n"
                                 "RuleBlock: off\n  enabled: false\n  rule: if x is very low then y is large\n"),
                             "a.fll");
  // The hedge cannot be read even there.
  EXPECT_EQ(from.refusal,
            "a.fll: line 31, column 17: found the hedge 'very', wanted terms without hedges, which Tactus lacks");
  const auto plain = imported(fll("  rule: if x is low then y is small\n"
                                  "RuleBlock: off\n  enabled: false\n  conjunction: EinsteinProduct\n"
                                  "  rule: if x is low and z is low then y is large\n"),
                              "a.fll");
  EXPECT_EQ(force(plain, {0, 0}), 2);
  warns(plain, "a.fll: the rule block 'off' is disabled; its 1 rules are left out");
}

TEST(Fll, ADisabledInputMakesItsConditionsFalse) {
  std::string text = fll("  rule: if x is low then y is small\n  rule: if x is high or z is high then y is large\n");
  text.replace(text.find("InputVariable: z\n"), 17, "InputVariable: z\n  enabled: false\n");
  const auto from = imported(text, "a.fll");
  EXPECT_EQ(force(from, {0, 10}), 2);
  EXPECT_EQ(force(from, {10, 0}), 6);
  warns(from, "the input 'z' is disabled in the file; conditions on it never hold");
}

TEST(Fll, WhatChangesNoForceIsWarnedAbout) {
  std::string text =
      fll("  rule: if x is low then y is small\n", "  term: odd Bell 5 2 3\n  term: far Triangle 20 30 40\n");
  text.replace(text.find("lock-previous: false"), 20, "lock-previous: true");
  const auto from = imported(text, "a.fll");
  ASSERT_TRUE(from.model) << from.refusal;
  warns(from, "a.fll: line 8, column 9: term 'odd' of 'x' is left out: found 'Bell', wanted a trapezoid");
  warns(from, "a.fll: line 9, column 9: term 'far' of 'x' lies outside the range of 0 to 10");
  warns(from, "the input 'z' is in no rule");
  warns(from, "the last value is kept where no rule fires");
  EXPECT_EQ(from.model->inputs.size(), 2U);
  EXPECT_EQ(from.model->inputs[0].terms.size(), 3U);
  EXPECT_NE(from.model->provenance->notes.find("'odd'"), std::string::npos);
}

TEST(Fll, TheDefaultIsTheForceWhereNoRuleFires) {
  std::string text = fll("  rule: if x is low then y is small\n");
  text.replace(text.find("default: nan"), 12, "default: 1.5");
  const auto from = imported(text, "a.fll");
  ASSERT_TRUE(from.model) << from.refusal;
  EXPECT_EQ(from.model->default_force_n, 1.5);
}

TEST(Fll, NamesThatAreNoIdsStayAsLabels) {
  const auto from = imported(fll("  rule: if x is h\xC3\xB6her then y is small\n",
                                 "  term: h\xC3\xB6her Triangle 0 5 10\n"
                                 "  term: \xE6\x85\xA2 Triangle 0 5 10\n"),
                             "a.fll");
  ASSERT_TRUE(from.model) << from.refusal;
  EXPECT_EQ(from.model->inputs[0].terms[2].id, "h_her");
  EXPECT_EQ(from.model->inputs[0].terms[2].label, "h\xC3\xB6her");
  EXPECT_EQ(from.model->inputs[0].terms[3].id, "term_4");
}

}  // namespace
}  // namespace tactus::exchange
