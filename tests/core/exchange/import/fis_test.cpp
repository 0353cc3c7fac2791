// FIS of MATLAB, Octave and fuzzylite.
#include "tests/core/exchange/import/imported.h"

namespace tactus::exchange {
namespace {

const std::string kTwoFisRules = "1 0, 1 (1) : 1\n0 1, 2 (0.5) : 1\n";

TEST(Fis, AModelIsReadWithItsForces) {
  const auto from = imported(fis(kTwoFisRules), "pair.fis");
  ASSERT_TRUE(from.model) << from.refusal;
  EXPECT_TRUE(from.warnings.empty());
  EXPECT_NEAR(force(from, {3, 3}), kAtThree, 1e-14);
  // Shoulders beyond the range are put back to its ends.
  EXPECT_EQ(from.model->inputs[0].terms[0].points, (std::vector<double>{0, 0, 2, 4}));
  EXPECT_EQ(from.model->inputs[0].terms[1].points, (std::vector<double>{2, 4, 10, 10}));
}

TEST(Fis, OddFormsOfTheSameFile) {
  const std::string plain = fis(kTwoFisRules);
  const std::string texts[] = {
      plain.substr(0, plain.size() - 1),
      replaced(plain, "\n", "\r\n"),
      "\xEF\xBB\xBF" + plain,
      "% written by hand\n## a license\n" + plain,
      replaced(plain, "\n", "\n  "),
      replaced(plain, "=", " = "),
      replaced(plain, "Version=2.0\n", ""),
      replaced(plain, "Version=2.0", "Version=6.0"),
      replaced(plain, "[0 10]", "[0, 10]"),
      replaced(plain, "1 0, 1 (1) : 1", "1.000 0.000 , 1.000 (1.000) : 1"),
      replaced(plain, "1 0, 1 (1) : 1", "# RuleBlock first\n1 0,1(1):1"),
      replaced(plain, "1 0, 1 (1) : 1", "1 0, 1 (1) : 2"),
      replaced(plain, "Name='x'\n", "Name='x'\nEnabled=1\nDefault=NaN\nLockPrevious=0\nLockRange=1\n"),
      replaced(plain, "'trapmf',[-10 0 2 4]", "'trapmf',[-Inf -Inf 2 4]"),
      replaced(plain, "'trapmf',[-10 0 2 4]", "'discretemf',[0 1 2 1 4 0]"),
      replaced(plain, "AndMethod='min'", "AndMethod=''"),
      replaced(plain, "AndMethod='min'", "AndMethod='einstein_product'"),
      replaced(plain, "OrMethod='max'", "OrMethod='probor'"),
  };
  for (const std::string& text : texts) {
    const auto from = imported(text, "pair.fis");
    ASSERT_TRUE(from.model) << from.refusal << "\n" << text;
    EXPECT_NEAR(force(from, {3, 3}), kAtThree, 1e-14) << text;
  }
}

TEST(Fis, NotAndOrByNumber) {
  const auto from = imported(fis("-1 1, 1 (1) : 1\n1 2, 2 (1) : 2\n"), "a.fis");
  // At x = 3, z = 2.5: not low 0.5 and low 0.75: 0.5; low 0.5 or high 0.25: 0.5.
  EXPECT_NEAR(force(from, {3, 2.5}), 4, 1e-13);
  EXPECT_NEAR(force(from, {10, 10}), 6, 1e-13);
}

TEST(Fis, GaussiansHaveSigmaFirst) {
  const auto from = imported(replaced(fis(kTwoFisRules), "'trapmf',[-10 0 2 4]", "'gaussmf',[2 5]"), "a.fis");
  ASSERT_TRUE(from.model) << from.refusal;
  EXPECT_EQ(from.model->inputs[0].terms[0].points, (std::vector<double>{5, 2}));
}

TEST(Fis, CountsThatDoNotMatchAreWarnedAbout) {
  const auto from = imported(
      replaced(replaced(fis(kTwoFisRules), "NumInputs=2", "NumInputs=3\nNumRules=9"), "NumMFs=2", "NumMFs=5"), "a.fis");
  ASSERT_TRUE(from.model) << from.refusal;
  warns(from, "a.fis: the file says 3 inputs and has 2");
  warns(from, "a.fis: the file says 9 rules and has 2");
  warns(from, "a.fis: the file says 5 terms of 'x' and has 2");
}

TEST(Fis, NamesOfPeople) {
  const auto from = imported(replaced(replaced(fis(kTwoFisRules), "'low'",
                                               "'S\xC4\xB1"
                                               "f\xC4\xB1r'"),
                                      "Name='y'", "Name='dV*'"),
                             "a.fis");
  ASSERT_TRUE(from.model) << from.refusal;
  EXPECT_EQ(from.model->output.id, "dV");
  EXPECT_EQ(from.model->output.label, "dV*");
  EXPECT_EQ(from.model->inputs[0].terms[0].id, "S_f_r");
  EXPECT_EQ(imported(replaced(fis(kTwoFisRules), "'high'", "'low '"), "a.fis").refusal,
            "a.fis: line 18, column 6: found term 'low ' of 'x' with the id 'low' of an earlier term, wanted names "
            "that differ "
            "in letters and digits");
}

TEST(Fis, WhatIsRefused) {
  const std::string plain = fis(kTwoFisRules);
  const auto refused = [](const std::string& text) { return imported(text, "a.fis").refusal; };
  EXPECT_EQ(refused(replaced(plain, "'mamdani'", "'sugeno'")),
            "a.fis: line 3, column 7: found a system of the type 'sugeno', wanted 'mamdani', the only type that Tactus "
            "knows");
  EXPECT_EQ(refused(replaced(plain, "'centroid'", "'bisector'")),
            "a.fis: line 11, column 15: found the defuzzifier 'bisector', wanted centroid, all that Tactus has");
  EXPECT_EQ(refused(replaced(plain, "AggMethod='max'", "AggMethod='sum'")),
            "a.fis: line 10, column 12: found the aggregation 'sum', wanted max, all that Tactus has");
  EXPECT_EQ(refused(replaced(plain, "1 0, 1", "3 0, 1")),
            "a.fis: line 35, column 1: found term '3', wanted a number from 1 to 2, the terms of 'x'");
  EXPECT_EQ(
      refused(replaced(plain, "1 0, 1", "0 0, 1")),
      "a.fis: line 35, column 1: found a rule whose condition asks for no term, wanted a term of one input or more");
  EXPECT_EQ(refused(replaced(plain, "1 0, 1", "1, 1")),
            "a.fis: line 35, column 2: found ', 1 (1) : 1', wanted the number of a term of 'z', one for each of the 2 "
            "inputs");
  const std::pair<std::string, std::string> hedges[] = {{"1.05", "the hedge 'somewhat'"},
                                                        {"1.20", "the hedge 'very'"},
                                                        {"1.3", "the hedge 'extremely'"},
                                                        {"1.4", "the hedge 'very very'"},
                                                        {"-2.300", "the hedge 'extremely'"}};
  for (const auto& [number, hedge] : hedges) {
    EXPECT_EQ(refused(replaced(plain, "1 0, 1", number + " 0, 1")),
              "a.fis: line 35, column 1: found " + hedge + " in '" + number +
                  "', wanted terms without hedges, which Tactus lacks");
  }
  EXPECT_EQ(refused(replaced(plain, "'trapmf',[-10 0 2 4]", "'gbellmf',[1 2 3]")),
            "a.fis: line 17, column 12, term 'low': found 'gbellmf', wanted a trapezoid, a triangle, a Gaussian or "
            "points that "
            "make a trapezoid");
  EXPECT_EQ(refused(replaced(plain, "MF2='high'", "MF3='high'")),
            "a.fis: line 18, column 1: found 'MF3', wanted MF2, the next one");
  EXPECT_EQ(refused(replaced(plain, "[-10 0 2 4]", "[-10 0 2 4")),
            "a.fis: line 17, column 30: found the end of the line, wanted a term as in 'low':'trimf',[0 1 2]");
  EXPECT_EQ(
      refused(replaced(plain, "MF1='low'", "UMF1='low'")),
      "a.fis: line 17, column 1: found a term of type 2, wanted terms of type 1: Tactus lacks upper and lower terms");
  EXPECT_EQ(refused(replaced(plain, "Range=[0 8]", "Range=[8 0]")),
            "a.fis: line 29, column 7: found '[8 0]', wanted two numbers, the lower one first, as in [0 1]");
  EXPECT_EQ(refused(fis("")), "a.fis: found no rule for 'y', wanted one rule or more");
  EXPECT_EQ(refused(plain.substr(0, plain.find("[Output1]"))), "a.fis: found no output, wanted an output, the force");
}

}  // namespace
}  // namespace tactus::exchange
