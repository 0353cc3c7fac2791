// FCL of IEC 61131-7 and of fuzzylite.
#include "tests/core/exchange/import/imported.h"

namespace tactus::exchange {
namespace {

const std::string kTwoFclRules =
    "RULE 1 : IF x IS low THEN y IS small;\nRULE 2 : IF z IS low THEN y IS large WITH 0.5;\n";

TEST(Fcl, AModelIsReadWithItsForces) {
  const auto from = imported(fcl(kTwoFclRules), "pair.fcl");
  ASSERT_TRUE(from.model) << from.refusal;
  EXPECT_NEAR(force(from, {3, 3}), kAtThree, 1e-14);
  EXPECT_EQ(from.model->inputs[0].max, 10);
  EXPECT_EQ(from.model->output.max, 8);
  EXPECT_EQ(from.model->inputs[0].terms[0].points, (std::vector<double>{0, 0, 2, 4}));
  // IEC has no range of inputs.
  warns(from, "pair.fcl: line 3, column 3: no range of 'x' is stated; that of its terms is taken, 0 to 10");
}

TEST(Fcl, OddFormsOfTheSameFile) {
  const std::string plain = fcl(kTwoFclRules);
  const std::string texts[] = {
      plain.substr(0, plain.size() - 1),
      replaced(plain, ";\n", ";\r\n"),
      "\xEF\xBB\xBF" + plain,
      "(* a comment\n over lines *) // and another\n/* a third */ # a fourth\n% a fifth\n" + plain,
      replaced(plain, "(0, 1) (2, 1) (4, 0)", "(0,1)(2,1)(4,0)"),
      replaced(plain, "(0, 1) (2, 1) (4, 0)", "(0,1),(2.0,1),(4e0,0.0)"),
      replaced(plain, "(0, 1) (2, 1) (4, 0)", "(0, 1) (0.2E1, 1) (+4, 0)"),
      replaced(plain, "(0 .. 8)", "(0..8)"),
      replaced(plain, "METHOD : COG", "method:CoG"),
      replaced(plain, " IF x IS low THEN y IS small", " if x is low then\n  y is small"),
      replaced(plain, "RULE 1 : IF x IS low", "RULE first:IF (x IS low)"),
      replaced(plain, "RULE 1", "RULE 01"),
      replaced(plain, "RULEBLOCK rules", "RULEBLOCK"),
      replaced(plain, "FUNCTION_BLOCK pair\n", "FUNCTION_BLOCK\n"),
      replaced(plain, "x : REAL;", "x : INT := 3; (* RANGE(0 .. 23) *)"),
      replaced(plain, "AND : MIN;", "AND :MIN ;"),
      replaced(plain, "ACT : PROD;", "ACT  :  PROD;"),
      replaced(plain, "x IS low", "X is LOW"),
      replaced(replaced(plain, "low", "satISfactory"), "high", "iforthen"),
      replaced(plain, "DEFAULT := 0;", "DEFAULT := nan;"),
      replaced(plain, "ACCU : MAX;", ""),
      replaced(plain, "METHOD : COG;", ""),
      replaced(plain, "OR : MAX;", ""),
      replaced(plain, "METHOD : COG;", "METHOD : COG; ACCU : MAX;"),
      replaced(plain, "END_RULEBLOCK", "END_RULEBLOCK\nRULEBLOCK second\nACT : PROD; ACCU : MAX;\nEND_RULEBLOCK"),
  };
  for (const std::string& text : texts) {
    const auto from = imported(text, "pair.fcl");
    ASSERT_TRUE(from.model) << from.refusal << "\n" << text;
    EXPECT_NEAR(force(from, {3, 3}), kAtThree, 1e-14) << text;
  }
}

TEST(Fcl, TheDialectOfFuzzylite) {
  std::string text = replaced(fcl(replaced(kTwoFclRules, ";", "")), "TERM low := (0, 1) (2, 1) (4, 0)",
                              "RANGE := (0.000 .. 10.000);\n  TERM low := Trapezoid 0.000 0.000 2.000 4.000");
  text = replaced(text, "TERM high := (2, 0) (4, 1) (10, 1)", "TERM high := Ramp 2.000 4.000 1.000");
  text = replaced(text, "(1, 0) (2, 1) (3, 0)", "Triangle 1 2 3");
  text = replaced(text, "DEFAULT := 0", "ACCU : MAX;\n  DEFAULT := 0.5 | NC;\n  LOCK : PREVIOUS | RANGE");
  text = replaced(text, "AND : MIN; OR : MAX; ACT : PROD; ACCU : MAX;",
                  "ENABLED : TRUE\n  AND : MIN\n  ACT : PROD\n  ACTIVATION : General");
  const auto from = imported(text, "pair.fcl");
  ASSERT_TRUE(from.model) << from.refusal;
  EXPECT_NEAR(force(from, {3, 3}), kAtThree, 1e-14);
  EXPECT_EQ(from.model->default_force_n, 0.5);
  EXPECT_EQ(from.model->inputs[0].terms[1].points, (std::vector<double>{2, 4, 10, 10}));
  warns(from, "the last value is kept where no rule fires");
}

TEST(Fcl, WordsForShapes) {
  for (const std::string word : {"TRIAN 1 2 3", "trian 1 2 3", "Triangle 1 2 3", "triangular 1 2 3", "trape 1 2 2 3"}) {
    const auto from = imported(replaced(fcl(kTwoFclRules), "(1, 0) (2, 1) (3, 0)", word), "a.fcl");
    EXPECT_NEAR(force(from, {3, 3}), kAtThree, 1e-14) << word;
  }
  const auto gauss = imported(replaced(fcl(kTwoFclRules), "(0, 1) (2, 1) (4, 0)", "GAUSS 0 2"), "a.fcl");
  ASSERT_TRUE(gauss.model) << gauss.refusal;
  EXPECT_EQ(gauss.model->inputs[0].terms[0].points, (std::vector<double>{0, 2}));
  // Four sigmas belong to the range that the terms span.
  EXPECT_EQ(gauss.model->inputs[0].min, -8);
}

TEST(Fcl, AndBeforeOrIsSaidWhereProgramsDiffer) {
  const auto differs = imported(fcl("RULE 1 : IF x IS low OR x IS high AND z IS low THEN y IS small;\n"), "a.fcl");
  EXPECT_TRUE(fires(differs, {0, 10}));
  warns(differs, "a.fcl: line 23, column 35: AND binds closer than OR");
  for (const std::string same : {"x IS low AND z IS low OR x IS high", "x IS low OR (x IS high AND z IS low)"}) {
    const auto from = imported(fcl("RULE 1 : IF " + same + " THEN y IS small;\n"), "a.fcl");
    EXPECT_EQ(from.warnings.size(), 2U) << same;  // of the ranges
  }
}

TEST(Fcl, OneOutputIsChosen) {
  std::string text = fcl("RULE 1 : IF x IS low THEN y IS small, w IS big;\nRULE 2 : IF x IS high THEN w IS big;\n");
  text = replaced(text, "VAR_OUTPUT y : REAL; END_VAR", "VAR_OUTPUT y : REAL; w : REAL; END_VAR");
  text = replaced(text, "RULEBLOCK rules",
                  "DEFUZZIFY w\nTERM big := SIGM 1 2;\nMETHOD : COA;\nEND_DEFUZZIFY\nRULEBLOCK rules");
  EXPECT_EQ(imported(text, "a.fcl").refusal,
            "a.fcl: found 2 outputs, 'y', 'w', wanted the choice of one of them, the force");
  EXPECT_EQ(imported(text, "a.fcl", "v").refusal, "a.fcl: found no output 'v', wanted one of 'y', 'w'");
  // A rule that follows another one does not matter where it concludes on the other output.
  text = replaced(text, "RULE 2 : IF x IS high THEN", "RULE 2 : IF y IS small THEN");
  const auto y = imported(text, "a.fcl", "y");
  EXPECT_EQ(force(y, {0, 0}), 2);
  EXPECT_FALSE(fires(y, {10, 0}));
  EXPECT_EQ(
      imported(text, "a.fcl", "w").refusal,
      "a.fcl: line 28, column 13: found the output 'y' in a condition, wanted inputs: Tactus has no rules that follow "
      "rules");
}

std::string refused(const std::string& text) { return imported(text, "a.fcl").refusal; }

TEST(Fcl, WhatIsRefused) {
  const std::string plain = fcl(kTwoFclRules);
  EXPECT_EQ(refused(replaced(plain, "x IS low", "x IS lo")),
            "a.fcl: line 23, column 18: found the unknown term 'lo', wanted a term of 'x': 'low', 'high' (low?)");
  EXPECT_EQ(
      refused(replaced(plain, "IF x IS low", "IF y IS small")),
      "a.fcl: line 23, column 13: found the output 'y' in a condition, wanted inputs: Tactus has no rules that follow "
      "rules");
  EXPECT_EQ(
      refused(replaced(plain, "THEN y", "THEN q")),
      "a.fcl: line 23, column 27: found the unknown variable 'q', wanted an output in this part of a rule: 'y' (y?)");
  EXPECT_EQ(refused(replaced(plain, "WITH 0.5", "WITH strong")),
            "a.fcl: line 24, column 43: found 'strong', wanted the weight of the rule, a number");
  EXPECT_EQ(refused(replaced(plain, "WITH 0.5", "WITH 1.5")),
            "a.fcl: line 24, column 43: found the weight 1.5, wanted a weight from 0 to 1");
  EXPECT_EQ(refused(replaced(plain, "x IS low THEN", "x IS low")),
            "a.fcl: line 23, column 22: found 'y', wanted AND, OR, THEN or the end of the rule");
  EXPECT_EQ(
      refused(replaced(plain, "METHOD : COG", "METHOD : COGS")),
      "a.fcl: line 19, column 12: found the defuzzifier 'COGS' of a Takagi-Sugeno or Tsukamoto system, wanted COG, all "
      "that Tactus has");
  EXPECT_EQ(refused(replaced(plain, "(1, 0) (2, 1) (3, 0)", "-27")),
            "a.fcl: line 16, column 17, term 'small': found 'singleton', wanted a trapezoid, a triangle, a Gaussian or "
            "points that make a trapezoid");
  EXPECT_EQ(
      refused(replaced(plain, "(1, 0) (2, 1)", "(1, 0) (x, 1)")),
      "a.fcl: line 16, column 25: found the variable 'x' in a term, wanted numbers: a term of Tactus does not change "
      "with a variable");
  EXPECT_EQ(refused(replaced(plain, "ACT : PROD", "ACT : BDIF")),
            "a.fcl: line 22, column 30: found the implication 'BDIF', wanted MIN or PROD, all that Tactus has");
  EXPECT_EQ(refused(replaced(plain, "ACCU : MAX", "ACCU : NSUM")),
            "a.fcl: line 22, column 43: found the aggregation 'NSUM', wanted MAX, all that Tactus has");
  EXPECT_EQ(refused(plain + plain),
            "a.fcl: line 27, column 1: found a second FUNCTION_BLOCK, wanted one: keep the one to be read in a file of "
            "its own");
  EXPECT_EQ(refused(replaced(plain, "FUZZIFY x", "FUZZIFY v")),
            "a.fcl: line 7, column 9: found 'v', wanted a variable that VAR_INPUT declares");
  EXPECT_EQ(refused(replaced(plain, "END_RULEBLOCK\nEND_FUNCTION_BLOCK\n", "")),
            "a.fcl: line 25, column 1: found the end of the file, wanted RULE, AND, OR, ACT, ACCU or END_RULEBLOCK");
  EXPECT_EQ(refused(replaced(plain, "FUZZIFY x", "(* FUZZIFY x")),
            "a.fcl: line 7, column 1: found a comment without an end, wanted '*)'");
  EXPECT_EQ(refused(fcl("")), "a.fcl: found no rule for 'y', wanted one rule or more");
  EXPECT_EQ(refused(replaced(plain, "(0 .. 8)", "(8 .. 0)")),
            "a.fcl: line 18, column 3: found 8 .. 0, wanted a range from a lower to a higher number");
  EXPECT_EQ(refused(fcl("RULE 1 : IF x IS low AND z IS low THEN y IS small;\n", "METHOD : COG;",
                        "AND : PROD; ACT : MIN; ACCU : MAX;")),
            "a.fcl: line 22, column 9: found the conjunction 'PROD', wanted MIN, all that Tactus has");
}

}  // namespace
}  // namespace tactus::exchange
