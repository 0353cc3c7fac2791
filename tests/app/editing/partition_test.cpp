#include <gtest/gtest.h>

#include "app/editing/term_edits.h"

#include "tests/app/editing/sample_models.h"

namespace tactus::editing {
namespace {

using Points = std::vector<double>;

TEST(Partition, TheDefaultTermsSumToOne) {
  const auto model = support::s4AsPrinted();
  for (const auto& input : model.inputs) {
    EXPECT_TRUE(partitionOrder(input, input.terms)) << input.id;
    EXPECT_LE(furthestFromOne(input, input.terms, 1000), 1e-15) << input.id;
  }
  EXPECT_TRUE(partitionOrder(model.output, model.output.terms));
}

TEST(Partition, GapsGaussiansAndOpenEndsAreNone) {
  const auto model = support::s4AsPrinted();
  auto depth = model.inputs[2];
  depth.terms[1].points[3] = 124;
  EXPECT_FALSE(partitionOrder(depth, depth.terms));
  depth = model.inputs[2];
  depth.terms[0].points = {5, 5, 60, 80};
  EXPECT_FALSE(partitionOrder(depth, depth.terms));
  depth = model.inputs[2];
  depth.terms[2] = {"g", "", fuzzy::Shape::kGaussian, {100, 10}};
  EXPECT_FALSE(partitionOrder(depth, depth.terms));
}

TEST(Partition, NeighborsShareTheMeanOfTheirEdges) {
  auto model = support::s4AsPrinted();
  // Nasopharynx ends at 101 121, oropharynx begins at 109 129: they meet at 105 125. The ends are stretched.
  model.inputs[2].terms[0].points[0] = 3;
  model.inputs[2].terms[0].points[1] = 10;
  model.inputs[2].terms[1].points = {60, 80, 101, 121};
  model.inputs[2].terms[2].points = {109, 129, 138, 162};
  const auto edit = must(makeSumToOne(model, kDepth));
  const auto& depth = edit.model.inputs[2];
  EXPECT_EQ(depth.terms[0].points, (Points{0, 0, 60, 80}));
  EXPECT_EQ(depth.terms[1].points, (Points{60, 80, 105, 125}));
  EXPECT_EQ(depth.terms[2].points, (Points{105, 125, 138, 162}));
  EXPECT_TRUE(partitionOrder(depth, depth.terms));
}

TEST(Partition, CrossingEdgesAreSorted) {
  auto model = support::s4AsPrinted();
  model.inputs[0].terms[0].points = {0, 0, 0.9, 1};
  model.inputs[0].terms[1].points = {0, 0.1, 0.1, 0.2};
  model.inputs[0].terms[2].points = {0, 0.05, 1, 1};
  const auto edit = must(makeSumToOne(model, {"lubrication", ""}));
  EXPECT_TRUE(partitionOrder(edit.model.inputs[0], edit.model.inputs[0].terms));
  EXPECT_LE(furthestFromOne(edit.model.inputs[0], edit.model.inputs[0].terms, 1000), 1e-9);
}

}  // namespace
}  // namespace tactus::editing
