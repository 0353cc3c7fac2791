#include "app/editing/membership_edits.h"

#include <gtest/gtest.h>
#include <limits>

#include "app/editing/edit.h"
#include "app/editing/term_edits.h"

#include "tests/app/editing/sample_models.h"

namespace tactus::editing {
namespace {

using Points = std::vector<double>;

const MoveOptions kSumToOne{true, {}};

class MembershipEdits : public testing::Test {
 protected:
  // Depth: nasal cavity 0 0 60 80, nasopharynx 60 80 105 125, oropharynx 105 125 138 162.
  const fuzzy::ForceModel model_ = support::s4AsPrinted();
};

TEST_F(MembershipEdits, AVertexGoesWhereItIsPut) {
  const auto edit = must(moveVertex(model_, {kDepth, "nasopharynx", 3}, 132));
  EXPECT_EQ(pointsOf(edit.model, "depth", "nasopharynx"), (Points{60, 80, 105, 132}));
  EXPECT_EQ(pointsOf(edit.model, "depth", "oropharynx"), (Points{105, 125, 138, 162}));
  EXPECT_EQ(edit.label, "Depth / nasopharynx: right foot 125 to 132 mm");
  EXPECT_EQ(edit.stopped, "");
}

TEST_F(MembershipEdits, AVertexStopsAtItsNeighborExactly) {
  const auto edit = must(moveVertex(model_, {kDepth, "nasopharynx", 1}, 300));
  EXPECT_EQ(pointsOf(edit.model, "depth", "nasopharynx"), (Points{60, 105, 105, 125}));
  EXPECT_EQ(edit.stopped, "the right shoulder of nasopharynx");
  EXPECT_EQ(pointsOf(must(moveVertex(model_, {kDepth, "nasopharynx", 1}, -1e300)).model, "depth", "nasopharynx"),
            (Points{60, 60, 105, 125}));
}

TEST_F(MembershipEdits, AVertexEndsOneUniverseOutside) {
  // The universe is 0 to 600 mm.
  EXPECT_EQ(pointsOf(must(moveVertex(model_, {kDepth, "nasopharynx", 3}, 1e9)).model, "depth", "nasopharynx").back(),
            1200);
  EXPECT_EQ(pointsOf(must(moveVertex(model_, {kDepth, "nasopharynx", 0}, -1e9)).model, "depth", "nasopharynx").front(),
            -600);
}

TEST_F(MembershipEdits, NumbersThatAreNoneAreRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal(moveVertex(model_, {kDepth, "nasopharynx", 3}, nan)),
            "Depth / nasopharynx: found nan, wanted a finite number");
  refusal(moveVertex(model_, {kDepth, "nasopharynx", 3}, infinity));
  refusal(moveEdge(model_, {kDepth, "nasopharynx"}, Side::kLeft, nan));
  refusal(moveTerm(model_, {kDepth, "nasopharynx"}, -infinity));
  refusal(setPoints(model_, {kDepth, "nasopharynx"}, Points{60, 80, nan, 125}));
}

TEST_F(MembershipEdits, PlacesThatAreNotThereAreRefused) {
  refusal(moveVertex(model_, {{"heat", ""}, "hot", 0}, 1));
  refusal(moveVertex(model_, {kDepth, "elbow", 0}, 1));
  refusal(moveVertex(model_, {kDepth, "nasopharynx", 4}, 1));
  EXPECT_EQ(refusal(moveVertex(model_, {{"depth", "S4"}, "nasopharynx", 0}, 1)),
            "terms of 'depth': found the shared list for expert 'S4', wanted an own list of that expert");
  refusal(moveVertex(model_, {{"depth", "S9"}, "nasopharynx", 0}, 1));
}

TEST_F(MembershipEdits, AnEdgeAndAWholeTermMoveTogether) {
  EXPECT_EQ(pointsOf(must(moveEdge(model_, {kDepth, "nasopharynx"}, Side::kRight, 7)).model, "depth", "nasopharynx"),
            (Points{60, 80, 112, 132}));
  const auto moved = must(moveTerm(model_, {kDepth, "nasopharynx"}, -8));
  EXPECT_EQ(pointsOf(moved.model, "depth", "nasopharynx"), (Points{52, 72, 97, 117}));
  EXPECT_EQ(moved.label, "Depth / nasopharynx: moved by -8 mm");
  // The left shoulder lies 25 mm before the right one.
  EXPECT_EQ(pointsOf(must(moveEdge(model_, {kDepth, "nasopharynx"}, Side::kLeft, 70)).model, "depth", "nasopharynx"),
            (Points{85, 105, 105, 125}));
}

TEST_F(MembershipEdits, WhereTermsSumToOneTheNeighborMovesAlong) {
  const auto edit = must(moveVertex(model_, {kDepth, "nasopharynx", 3}, 132, kSumToOne));
  EXPECT_EQ(pointsOf(edit.model, "depth", "nasopharynx"), (Points{60, 80, 105, 132}));
  EXPECT_EQ(pointsOf(edit.model, "depth", "oropharynx"), (Points{105, 132, 138, 162}));
  // It stops at the neighbor's shoulder; the term itself would go farther.
  const auto far = must(moveVertex(model_, {kDepth, "nasopharynx", 3}, 150, kSumToOne));
  EXPECT_EQ(pointsOf(far.model, "depth", "nasopharynx"), (Points{60, 80, 105, 138}));
  EXPECT_EQ(far.stopped, "the right shoulder of oropharynx");
  EXPECT_LE(furthestFromOne(variableIn(far.model, "depth"), variableIn(far.model, "depth").terms, 6000), 1e-15);
}

TEST_F(MembershipEdits, AWholeTermTakesBothNeighborsAlong) {
  const auto edit = must(moveTerm(model_, {kDepth, "nasopharynx"}, 5, kSumToOne));
  EXPECT_EQ(pointsOf(edit.model, "depth", "nasal_cavity"), (Points{0, 0, 65, 85}));
  EXPECT_EQ(pointsOf(edit.model, "depth", "nasopharynx"), (Points{65, 85, 110, 130}));
  EXPECT_EQ(pointsOf(edit.model, "depth", "oropharynx"), (Points{110, 130, 138, 162}));
  // An end term keeps the end of the universe.
  const auto first = must(moveTerm(model_, {kDepth, "nasal_cavity"}, 5, kSumToOne));
  EXPECT_EQ(pointsOf(first.model, "depth", "nasal_cavity"), (Points{0, 0, 65, 85}));
  EXPECT_EQ(pointsOf(first.model, "depth", "nasopharynx"), (Points{65, 85, 105, 125}));
}

TEST_F(MembershipEdits, APartitionWithATriangleStaysOne) {
  // Force: large is the triangle 0.6 0.7 0.8 between medium and very large, written as trapezoid .6 .7 .7 .8.
  auto model = model_;
  auto& large = model.output.terms[3];
  large.shape = fuzzy::Shape::kTriangle;
  large.points = {0.6, 0.7, 0.8};
  const auto edit = must(moveVertex(model, {kForce, "large", 1}, 0.65, kSumToOne));
  EXPECT_EQ(pointsOf(edit.model, "force", "large"), (Points{0.6, 0.65, 0.8}));
  EXPECT_EQ(pointsOf(edit.model, "force", "medium").back(), 0.65);
  EXPECT_EQ(pointsOf(edit.model, "force", "very_large").front(), 0.65);
}

TEST_F(MembershipEdits, TheModeIsRefusedWhereTermsDoNotSumToOne) {
  const auto apart = must(moveVertex(model_, {kDepth, "nasopharynx", 3}, 120)).model;
  EXPECT_EQ(refusal(moveVertex(apart, {kDepth, "nasopharynx", 3}, 121, kSumToOne)),
            "Depth: found terms that do not sum to one, wanted terms that do, or to edit without that mode");
}

TEST_F(MembershipEdits, LockedVerticesStay) {
  const MoveOptions own{false, {{kDepth, "nasopharynx", 3}}};
  EXPECT_EQ(refusal(moveVertex(model_, {kDepth, "nasopharynx", 3}, 130, own)),
            "Depth / nasopharynx: found the right foot locked, wanted a vertex that is not locked");
  refusal(moveTerm(model_, {kDepth, "nasopharynx"}, 1, own));
  refusal(moveEdge(model_, {kDepth, "nasopharynx"}, Side::kRight, 1, own));
  must(moveEdge(model_, {kDepth, "nasopharynx"}, Side::kLeft, 1, own));
  // A locked vertex of the neighbor holds the one that lies on it.
  const MoveOptions neighbor{true, {{kDepth, "oropharynx", 1}}};
  refusal(moveVertex(model_, {kDepth, "nasopharynx", 3}, 130, neighbor));
}

TEST_F(MembershipEdits, OutputTermsKeepSomeWidthInTheUniverse) {
  // A millionth of 1.1 N.
  const auto edit = must(moveVertex(model_, {kForce, "very_small", 3}, -5));
  EXPECT_EQ(pointsOf(edit.model, "force", "very_small"), (Points{0, 0, 0.2, 0.2}));
  auto thin = must(setPoints(model_, {kForce, "very_small"}, Points{0, 0, 0, 0.3})).model;
  thin = must(moveVertex(thin, {kForce, "very_small", 3}, -5)).model;
  EXPECT_EQ(pointsOf(thin, "force", "very_small").back(), 1e-6 * 1.1);
  const auto out = must(moveTerm(model_, {kForce, "very_large"}, 50));
  EXPECT_LT(pointsOf(out.model, "force", "very_large").front(), 1.1);
  EXPECT_FALSE(out.stopped.empty());
}

TEST_F(MembershipEdits, GaussiansHaveAMeanAndASigma) {
  auto model = model_;
  model.inputs[2].terms[1] = {"nasopharynx", "", fuzzy::Shape::kGaussian, {92, 14}};
  EXPECT_EQ(pointsOf(must(moveVertex(model, {kDepth, "nasopharynx", 0}, 95)).model, "depth", "nasopharynx"),
            (Points{95, 14}));
  EXPECT_EQ(pointsOf(must(moveVertex(model, {kDepth, "nasopharynx", 1}, -3)).model, "depth", "nasopharynx"),
            (Points{92, 1e-4 * 600}));
  EXPECT_EQ(pointsOf(must(moveTerm(model, {kDepth, "nasopharynx"}, 8)).model, "depth", "nasopharynx"),
            (Points{100, 14}));
  refusal(moveEdge(model, {kDepth, "nasopharynx"}, Side::kLeft, 1));
  refusal(moveVertex(model, {kDepth, "nasopharynx", 0}, 95, kSumToOne));
}

TEST_F(MembershipEdits, TypedPointsAreTakenOrRefused) {
  EXPECT_EQ(
      pointsOf(must(setPoints(model_, {kDepth, "nasopharynx"}, Points{1, 2, 3, 4})).model, "depth", "nasopharynx"),
      (Points{1, 2, 3, 4}));
  refusal(setPoints(model_, {kDepth, "nasopharynx"}, Points{1, 3, 2, 4}));
  refusal(setPoints(model_, {kDepth, "nasopharynx"}, Points{1, 2, 3}));
}

TEST(EditSteps, FollowTheUnit) {
  const auto variable = [](const char* unit, double min, double max) {
    return fuzzy::Variable{"x", "", unit, min, max, {}};
  };
  EXPECT_EQ(editStep(variable("mm", 0, 600), StepSize::kFine), 1);
  EXPECT_EQ(editStep(variable("mm", 0, 600), StepSize::kCoarse), 10);
  EXPECT_EQ(editStep(variable("deg", 0, 90), StepSize::kCoarse), 5);
  EXPECT_EQ(editStep(variable("N", 0, 1.1), StepSize::kFine), 0.01);
  EXPECT_EQ(editStep(variable("1", 0, 1), StepSize::kFine), 0.01);
  EXPECT_EQ(editStep(variable("1", 0, 1), StepSize::kCoarse), 0.1);
  EXPECT_EQ(editStep(variable("kPa", 0, 300), StepSize::kFine), 2);
}

TEST(EditSteps, StayOnTheGrid) {
  EXPECT_EQ(stepped(0.2, 0.1, 1), 0.3);  // 0.2 + 0.1 is 0.30000000000000004
  double value = 0;
  for (int k = 0; k < 70; ++k) value = stepped(value, 0.01, 1);
  EXPECT_EQ(value, 0.7);
  EXPECT_EQ(stepped(62.5, 10, -1), 52.5);
  EXPECT_EQ(stepped(60, 10, 2), 80);
}

}  // namespace
}  // namespace tactus::editing
