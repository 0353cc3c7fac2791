#include <gtest/gtest.h>
#include <limits>

#include "app/editing/term_edits.h"

#include "tests/app/editing/sample_models.h"

namespace tactus::editing {
namespace {

using Points = std::vector<double>;

class TermSplit : public testing::Test {
 protected:
  /// The esophagus, 185 215 420 460, in three near-equal parts.
  static SplitOptions thirds() {
    SplitOptions options;
    options.cuts = {290, 365};
    options.overlap = 20;
    return options;
  }
  const TermPlace esophagus_{kDepth, "esophagus"};
  const fuzzy::ForceModel model_ = support::s4AsPrinted();
};

TEST_F(TermSplit, TheEsophagusOfThePaperInSegments) {
  const auto edit = must(splitTerm(model_, esophagus_, thirds()));
  EXPECT_EQ(edit.label, "Depth / esophagus: split at 290, 365 mm");
  const auto& depth = edit.model.inputs[2];
  ASSERT_EQ(depth.terms.size(), 8);
  EXPECT_EQ(depth.terms[4].id, "esophagus_1");
  EXPECT_EQ(depth.terms[4].points, (Points{185, 215, 280, 300}));
  EXPECT_EQ(depth.terms[5].points, (Points{280, 300, 355, 375}));
  EXPECT_EQ(depth.terms[6].points, (Points{355, 375, 420, 460}));
  EXPECT_TRUE(partitionOrder(depth, depth.terms));
  EXPECT_LE(furthestFromOne(depth, depth.terms, 6000), 1e-15);
  // Nine of the 45 rules become three each.
  const auto& rules = edit.model.experts[0].rules;
  ASSERT_EQ(rules.size(), 63);
  // Rule 4 of Table A2: lubrication well and esophagus, medium.
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(rules[3 + k].conditions[1].term, "esophagus_" + std::to_string(k + 1));
    EXPECT_EQ(rules[3 + k].then, "medium");
  }
}

TEST_F(TermSplit, TheForceStaysBetweenTheOverlaps) {
  const auto edit = must(splitTerm(model_, esophagus_, thirds()));
  const auto before = fuzzy::compile(model_).value();
  for (const double depth : {30.0, 100.0, 170.0, 200.0, 240.0, 280.0, 320.0, 340.0, 380.0, 419.0, 440.0, 500.0}) {
    for (const double speed : {30.0, 80.0, 150.0}) {
      const Points at = {0.7, 40, depth, speed};
      EXPECT_EQ(edit.compiled.evaluate(at).force_n, before.evaluate(at).force_n) << depth;
    }
  }
}

TEST_F(TermSplit, ADefaultOverlapFitsTheParts) {
  // Mean of the ramps (30 + 40) / 2 = 35; half of the shortest piece of the core, 365 to 420, is 27.5.
  auto options = thirds();
  options.overlap.reset();
  const auto edit = must(splitTerm(model_, esophagus_, options));
  EXPECT_EQ(edit.model.inputs[2].terms[4].points, (Points{185, 215, 290 - 13.75, 290 + 13.75}));
}

TEST_F(TermSplit, NamesCanBeGiven) {
  auto options = thirds();
  options.names = {{"upper", "Upper"}, {"middle", "Middle"}, {"lower", "Lower"}};
  const auto edit = must(splitTerm(model_, esophagus_, options));
  EXPECT_EQ(edit.model.inputs[2].terms[6].label, "Lower");
  options.names.pop_back();
  refusal(splitTerm(model_, esophagus_, options));
  options.names = {{"upper", ""}, {"upper", ""}, {"lower", ""}};
  refusal(splitTerm(model_, esophagus_, options));
}

TEST_F(TermSplit, WithoutCopiesTheRulesStayInTheMiddle) {
  auto options = thirds();
  options.copy_rules = false;
  const auto edit = must(splitTerm(model_, esophagus_, options));
  ASSERT_EQ(edit.model.experts[0].rules.size(), 45);
  EXPECT_EQ(edit.model.experts[0].rules[3].conditions[1].term, "esophagus_2");  // the middle of the core is 317.5
}

TEST_F(TermSplit, ConsequentsAreNeverCopied) {
  SplitOptions options;
  options.cuts = {0.9};
  const auto edit = must(splitTerm(model_, {kForce, "very_large"}, options));
  EXPECT_EQ(edit.model.experts[0].rules.size(), 45);
  EXPECT_EQ(edit.model.output.terms.size(), 6);
  EXPECT_EQ(edit.model.experts[0].rules[11].then, "very_large_2");  // the middle of the core 0.8 to 1.1 is 0.95
}

TEST_F(TermSplit, CutsOutsideTheCoreAreRefused) {
  auto options = thirds();
  for (const Points& cuts : {Points{}, Points{200}, Points{215}, Points{365, 290}, Points{430},
                             Points{std::numeric_limits<double>::quiet_NaN()}}) {
    options.cuts = cuts;
    refusal(splitTerm(model_, esophagus_, options));
  }
  options.cuts = {217};
  EXPECT_EQ(refusal(splitTerm(model_, esophagus_, options)),
            "Depth / esophagus: found an overlap of 20, wanted more than 0, at most 4 mm");
  const auto triangle = fuzzy::Term{"esophagus", "", fuzzy::Shape::kTriangle, {185, 300, 460}};
  auto model = model_;
  model.inputs[2].terms[4] = triangle;
  options = thirds();
  refusal(splitTerm(model, esophagus_, options));
}

}  // namespace
}  // namespace tactus::editing
