// The texts for other programs, against the samples of the facts sheets.
#include "core/exchange/dialect.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <string>

#include "tests/support/ngt_model.h"
#include "tests/support/temp_folder.h"

namespace tactus::exchange {
namespace {

/// One input, one rule with a weight, a disabled one.
fuzzy::ForceModel small() {
  fuzzy::ForceModel model;
  model.name = "small";
  model.inputs.push_back({"lubrication",
                          "Tube lubrication",
                          "1",
                          0,
                          1,
                          {{"poor", "Poor", fuzzy::Shape::kTrapezoid, {0, 0, 0.2, 0.4}},
                           {"medium", "Medium", fuzzy::Shape::kTrapezoid, {0.2, 0.4, 0.6, 0.8}},
                           {"very", "Well", fuzzy::Shape::kTrapezoid, {0.6, 0.8, 1, 1}}}});
  model.output = {"force",
                  "Force",
                  "N",
                  0,
                  1.1,
                  {{"very small", "", fuzzy::Shape::kTrapezoid, {0, 0, 0.2, 0.3}},
                   {"Very_Small", "", fuzzy::Shape::kTriangle, {0.6, 0.7, 0.8}}}};
  fuzzy::Expert expert;
  expert.id = "S-4";
  expert.rules = {{{{"lubrication", "very"}}, "very small"},
                  {{{"lubrication", "poor"}}, "Very_Small", 0.5},
                  {{{"lubrication", "medium"}}, "Very_Small", 1, false}};
  model.experts.push_back(expert);
  return model;
}

std::string text(Dialect dialect) {
  const auto made = format(small(), 0, dialect);
  EXPECT_TRUE(made) << (made ? "" : made.error().message());
  return made.value_or("");
}

void expectLines(const std::string& text, const std::vector<std::string>& lines) {
  for (const std::string& line : lines)
    EXPECT_NE(text.find(line + "\n"), std::string::npos) << line << "\nin\n" << text;
}

TEST(Dialect, Fll) {
  expectLines(
      text(Dialect::kFll),
      {"Engine: force_model_S_4", "InputVariable: lubrication", "  range: 0 1", "  lock-range: true",
       "  term: poor Trapezoid 0 0 0.2 0.4", "  term: very_ Trapezoid 0.6 0.8 1 1", "  aggregation: Maximum",
       "  defuzzifier: Centroid 1000", "  default: nan", "  implication: Minimum",
       "  term: Very_Small_2 Triangle 0.6 0.7 0.8", "  rule: if lubrication is very_ then force is very_small",
       "  rule: if lubrication is poor then force is Very_Small_2 with 0.5", "# 1 disabled rules are left out"});
}

TEST(Dialect, FclOfIec) {
  expectLines(text(Dialect::kFclIec),
              {"  TERM poor := (0, 1) (0.2, 1) (0.4, 0);", "  TERM medium := (0.2, 0) (0.4, 1) (0.6, 1) (0.8, 0);",
               "  TERM very_ := (0.6, 0) (0.8, 1) (1, 1);", "  TERM Very_Small_2 := (0.6, 0) (0.7, 1) (0.8, 0);",
               "  RANGE := (0 .. 1.1);", "  ACCU : MAX;",
               "  RULE 2 : IF lubrication IS poor THEN force IS Very_Small_2 WITH 0.5;"});
}

TEST(Dialect, FclOfFuzzylite) {
  expectLines(text(Dialect::kFclFuzzylite),
              {"  RANGE := (0 .. 1);", "  TERM poor := Trapezoid 0 0 0.2 0.4;", "  ACCU : MAX;", "  DEFAULT := nan;",
               "  RULE 1 : if lubrication is very_ then force is very_small"});
}

TEST(Dialect, FisMovesShouldersOut) {
  expectLines(text(Dialect::kFis),
              {"MF1='poor':'trapmf',[-1 0 0.2 0.4]", "MF3='very_':'trapmf',[0.6 0.8 1 2]", "NumRules=2", "3, 1 (1) : 1",
               "1, 2 (0.5) : 1", "MF2='Very_Small_2':'trimf',[0.6 0.7 0.8]", "ImpMethod='min'"});
}

TEST(Dialect, FisHasAnOnlyRuleTwice) {
  auto model = small();
  model.experts[0].rules.resize(1);
  const auto fis = format(model, 0, Dialect::kFis);
  ASSERT_TRUE(fis);
  expectLines(*fis, {"NumRules=2", "3, 1 (1) : 1\n3, 1 (1) : 1"});
}

TEST(Dialect, FmlIsWellFormedAndItsNamesAreUnique) {
  const std::string fml = text(Dialect::kFml);
  EXPECT_NE(fml.find("<fuzzyTerm name=\"lubrication__poor\"><trapezoidShape param1=\"0\" param2=\"0\" param3=\"0.2\" "
                     "param4=\"0.4\"/></fuzzyTerm>"),
            std::string::npos);
  EXPECT_NE(fml.find("weight=\"0.5\""), std::string::npos);
  if (std::system("command -v xmllint >/dev/null") != 0) GTEST_SKIP() << "xmllint is not here";
  const support::TempFolder folder;
  std::ofstream(folder.file("model.fml")) << fml;
  EXPECT_EQ(std::system(("xmllint --noout " + folder.file("model.fml")).c_str()), 0);
}

TEST(Dialect, EachTextNamesItsOriginInItsHead) {
  const Origin origin{std::string(64, 'a'), "2026-11-21T08:00:00Z", "tactus 1.2"};
  for (const Dialect dialect : kDialects) {
    const std::string plain = text(dialect);
    const auto made = format(small(), 0, dialect, origin);
    ASSERT_TRUE(made);
    const std::string head = made->substr(0, 300);
    EXPECT_NE(head.find("Model SHA-256 " + origin.model_sha256), std::string::npos) << *made;
    EXPECT_NE(head.find(", of 2026-11-21T08:00:00Z; exported by tactus 1.2"), std::string::npos) << *made;
    EXPECT_EQ(plain.find("SHA-256"), std::string::npos);
    // It is one line more, and the rest is the same.
    EXPECT_EQ(std::count(made->begin(), made->end(), '\n'), std::count(plain.begin(), plain.end(), '\n') + 1);
    EXPECT_EQ(*made, *format(small(), 0, dialect, origin)) << "the same model gives the same bytes";
  }
  const auto fml = format(small(), 0, Dialect::kFml, {std::string(64, 'a'), "a --> b ---- <x/>", "tactus"});
  EXPECT_NE(fml->find("a - -&gt; b - - - - &lt;x/&gt;"), std::string::npos) << *fml;
}

TEST(Dialect, EachTextNamesThePuncturesThatItCannotCarry) {
  auto model = support::s4FiveRegions();
  for (const Dialect dialect : kDialects)
    EXPECT_EQ(format(model, 0, dialect)->find("puncture"), std::string::npos) << name(dialect);
  model.events = {{"oropharynx", 0.6}};
  for (const Dialect dialect : kDialects) {
    EXPECT_NE(format(model, 0, dialect)->find("not in this file: puncture, oropharynx, 60 % of the force is lost"),
              std::string::npos)
        << name(dialect);
  }
}

TEST(Dialect, WhatFclCannotCarryIsRefused) {
  auto model = small();
  model.inputs[0].terms[1] = {"medium", "", fuzzy::Shape::kGaussian, {0.5, 0.1}};
  const auto refused = format(model, 0, Dialect::kFclIec);
  ASSERT_FALSE(refused);
  EXPECT_EQ(
      refused.error().message(),
      "term 'medium' of lubrication: found a Gaussian, wanted trapezoids and triangles, all that FCL of IEC 61131-7 "
      "can carry");
  const auto fis = format(model, 0, Dialect::kFis);
  ASSERT_TRUE(fis);
  EXPECT_NE(fis->find("MF2='medium':'gaussmf',[0.1 0.5]\n"), std::string::npos);
}

}  // namespace
}  // namespace tactus::exchange
