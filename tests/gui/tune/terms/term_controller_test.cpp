#include "app/workbench/tune/terms/term_controller.h"

#include <QSignalSpy>
#include <algorithm>
#include <gtest/gtest.h>

#include "app/editing/term_edits.h"

#include "tests/gui/sample_models.h"

namespace tactus::workbench {
namespace {

using Part = Grip::Part;
using Points = std::vector<double>;

constexpr Grip kNearRightFoot{0, Part::kVertex, 3, false};

class TermControllerTest : public testing::Test {
 protected:
  void SetUp() override { models.open(folder.write(tests::twoExperts())); }

  const Points& points(std::size_t term) const { return terms.terms()[term].points; }

  void drag(const Grip& grip, double by) {
    terms.beginMove(grip);
    terms.moveBy(by);
    terms.endMove();
  }

  tests::ModelFolder folder;
  ModelController models;
  EditController edits{models};
  TermController terms{edits};
};

TEST_F(TermControllerTest, BeginsWithTheWayOfTheTube) { EXPECT_EQ(terms.list().variable, "depth"); }

TEST_F(TermControllerTest, MovesAVertexAnEdgeAndATerm) {
  drag(kNearRightFoot, 0.5);
  EXPECT_EQ(points(0), (Points{0, 0, 4, 5.5}));
  drag({1, Part::kLeftEdge, 0, false}, 1);
  EXPECT_EQ(points(1), (Points{7, 8, 10, 10}));
  drag({0, Part::kTerm, 0, false}, 1);
  EXPECT_EQ(points(0), (Points{1, 1, 5, 6.5}));
}

TEST_F(TermControllerTest, AHandThatComesBackLeavesTheExactValue) {
  fuzzy::ForceModel model = tests::twoExperts();
  model.inputs[1].terms[0].points[3] = 5.123456;
  models.open(folder.write(model));
  terms.beginMove(kNearRightFoot);
  terms.moveBy(0.7);
  terms.moveBy(0.001);
  terms.endMove();
  EXPECT_EQ(points(0)[3], 5.123456);
  EXPECT_FALSE(edits.canUndo());
}

TEST_F(TermControllerTest, StopsAtTheNeighborAndSaysWhy) {
  terms.beginMove({0, Part::kVertex, 2, false});
  terms.moveBy(3);
  EXPECT_FALSE(edits.stopped().isEmpty());
  terms.endMove();
  EXPECT_EQ(points(0), (Points{0, 0, 5, 5}));
}

TEST_F(TermControllerTest, ALockedVertexStays) {
  terms.setLocked("near", 3, true);
  drag(kNearRightFoot, 0.5);
  drag({0, Part::kTerm, 0, false}, 0.5);
  EXPECT_EQ(points(0), (Points{0, 0, 4, 5}));
  terms.setLocked("near", 3, false);
  drag(kNearRightFoot, 0.5);
  EXPECT_EQ(points(0)[3], 5.5);
}

TEST_F(TermControllerTest, TermsThatSumToOneKeepIt) {
  terms.setVariable("speed");
  EXPECT_TRUE(terms.keepsSum());
  drag({0, Part::kVertex, 3, false}, 10);  // right foot of slow, 60; the left shoulder of fast lies on it
  EXPECT_EQ(points(0), (Points{0, 0, 40, 70}));
  EXPECT_EQ(points(1), (Points{40, 70, 100, 100}));

  terms.setKeepsSum(false);
  drag({0, Part::kVertex, 3, false}, 10);
  EXPECT_EQ(points(0), (Points{0, 0, 40, 80}));
  EXPECT_EQ(points(1), (Points{40, 70, 100, 100}));

  // Switched on again the neighbors meet in the middle, as one edit.
  terms.setKeepsSum(true);
  EXPECT_TRUE(terms.keepsSum());
  EXPECT_EQ(points(0), (Points{0, 0, 40, 75}));
  edits.undo();
  EXPECT_EQ(points(0), (Points{0, 0, 40, 80}));
}

TEST_F(TermControllerTest, TermsThatDoNotSumToOneAreEditedFreely) { EXPECT_FALSE(terms.keepsSum()); }

TEST_F(TermControllerTest, ArrowKeysStepFineAndCoarseAsOneGesture) {
  terms.setVariable("speed");
  terms.setKeepsSum(false);
  terms.select(Grip{0, Part::kVertex, 3, false});
  terms.step(1, false);
  terms.step(1, false);
  EXPECT_EQ(points(0)[3], 62);
  terms.step(-1, true);
  EXPECT_EQ(points(0)[3], 52);
  terms.endSteps();
  EXPECT_EQ(edits.history().line().size(), 2U);
  edits.undo();
  EXPECT_EQ(edits.model(), tests::twoExperts());
}

TEST_F(TermControllerTest, ArrowKeysLeaveAStopAtOnce) {
  terms.setVariable("speed");
  terms.setKeepsSum(false);
  terms.select(Grip{0, Part::kVertex, 2, false});  // 40, its neighbor is at 60
  for (int i = 0; i < 5; ++i) terms.step(1, true);
  EXPECT_EQ(points(0)[2], 60);
  terms.step(-1, false);
  EXPECT_EQ(points(0)[2], 59);
  terms.endSteps();
}

TEST_F(TermControllerTest, AGaussianGrowsToBothSides) {
  terms.convert("near", fuzzy::Shape::kGaussian);
  drag({0, Part::kVertex, 1, false}, 100);
  const double wide = points(0)[1];
  edits.undo();
  const double before = points(0)[1];
  EXPECT_GT(wide, before);
  drag({0, Part::kVertex, 1, true}, -0.5);        // the left handle, pulled to the left
  EXPECT_NEAR(points(0)[1], before + 0.5, 0.01);  // rounded to a hundredth of a mm
}

TEST_F(TermControllerTest, ConvertsAndUndoes) {
  terms.convert("near", fuzzy::Shape::kTriangle);
  EXPECT_EQ(points(0).size(), 3U);
  edits.undo();
  EXPECT_EQ(edits.model(), tests::twoExperts());
}

TEST_F(TermControllerTest, AddsRenamesAndRemoves) {
  terms.add(QStringLiteral(" Very far! "), 5.5);
  ASSERT_EQ(terms.terms().size(), 3U);
  EXPECT_EQ(terms.terms()[1].id, "very_far");
  EXPECT_EQ(terms.terms()[1].label, "Very far!");
  terms.rename("very_far", QStringLiteral("Middle"));
  EXPECT_EQ(terms.terms()[1].label, "Middle");
  EXPECT_EQ(terms.terms()[1].id, "very_far");
  terms.remove("very_far", false);
  EXPECT_EQ(terms.terms(), tests::twoExperts().inputs[1].terms);

  const QSignalSpy refused(&edits, &EditController::refused);
  EXPECT_EQ(terms.rulesOf("far"), 2U);
  terms.remove("far", false);
  EXPECT_EQ(refused.count(), 1);
  terms.remove("far", true);
  EXPECT_EQ(terms.terms().size(), 1U);
  while (edits.canUndo()) edits.undo();
  EXPECT_EQ(edits.model(), tests::twoExperts());
}

TEST_F(TermControllerTest, ANewTermMakesItsRoomWhereTermsSumToOne) {
  terms.setVariable("speed");
  terms.add(QStringLiteral("Very slow"), 10);
  ASSERT_EQ(terms.terms().size(), 3U);
  EXPECT_EQ(terms.terms()[0].id, "very_slow");
  EXPECT_EQ(terms.terms()[1].id, "slow");
  EXPECT_TRUE(editing::partitionOrder(terms.variable(), terms.terms()).has_value());
  const QSignalSpy refused(&edits, &EditController::refused);
  terms.add(QStringLiteral("Between"), 50);  // both terms hold it in part
  EXPECT_EQ(refused.count(), 1);
  EXPECT_EQ(terms.terms().size(), 3U);
}

TEST_F(TermControllerTest, SplitCopiesTheRules) {
  terms.split("far", {8.5});
  ASSERT_EQ(terms.terms().size(), 3U);
  EXPECT_EQ(edits.model().experts[0].rules.size(), 4U);
  EXPECT_EQ(edits.model().experts[1].rules.size(), 2U);
  edits.undo();
  EXPECT_EQ(edits.model(), tests::twoExperts());
}

TEST_F(TermControllerTest, AnExpertCanHaveOwnTerms) {
  terms.setExpert("A");
  EXPECT_TRUE(terms.list().expert.empty());
  EXPECT_EQ(terms.readers(), (std::vector<std::string>{"A", "B"}));
  terms.setOwnList(true);
  EXPECT_EQ(terms.list().expert, "A");
  EXPECT_EQ(terms.readers(), (std::vector<std::string>{"A"}));
  drag(kNearRightFoot, 0.5);
  EXPECT_EQ(points(0)[3], 5.5);
  EXPECT_EQ(edits.model().inputs[1].terms[0].points[3], 5);
  edits.undo();
  edits.undo();
  EXPECT_TRUE(terms.list().expert.empty());
  EXPECT_EQ(edits.model(), tests::twoExperts());
}

// Terms that A and B share, looked at as those of A: the first edit asks for whom it is.
TEST_F(TermControllerTest, AnEditOfSharedTermsAsksForWhom) {
  terms.setExpert("A");
  ASSERT_TRUE(terms.isSharedWithOthers());
  const QSignalSpy asked(&terms, &TermController::scopeAsked);
  drag(kNearRightFoot, 0.5);
  EXPECT_EQ(asked.count(), 1);
  EXPECT_EQ(edits.model(), tests::twoExperts());
  EXPECT_FALSE(edits.canUndo());

  terms.chooseScope(true);
  drag(kNearRightFoot, 0.5);
  EXPECT_EQ(asked.count(), 1);
  EXPECT_EQ(edits.model().inputs[1].terms[0].points[3], 5.5);
  EXPECT_TRUE(edits.model().experts[0].overrides.empty());
  EXPECT_EQ(edits.undoText(), QStringLiteral("Depth (A, B) / Near: right foot 5 to 5.5 mm"));
}

TEST_F(TermControllerTest, AnEditForOneExpertLeavesTheOthersAlone) {
  terms.setExpert("A");
  terms.setPoint("near", 3, 5.5);
  EXPECT_EQ(edits.model(), tests::twoExperts());
  terms.chooseScope(false);  // what waited is carried out
  EXPECT_EQ(terms.list().expert, "A");
  EXPECT_EQ(points(0)[3], 5.5);
  EXPECT_EQ(edits.model().inputs, tests::twoExperts().inputs);
  EXPECT_FALSE(terms.isSharedWithOthers());
  EXPECT_EQ(edits.undoText(), QStringLiteral("A, Depth / Near: right foot 5 to 5.5 mm"));
}

TEST_F(TermControllerTest, EveryWayToEditAsksForWhom) {
  const std::vector<std::function<void()>> ways = {
      [&] { drag(kNearRightFoot, 0.5); },
      [&] {
        terms.select(kNearRightFoot);
        terms.step(1, false);
        terms.endSteps();
      },
      [&] { terms.setPoint("near", 3, 5.5); },
      [&] { terms.convert("far", fuzzy::Shape::kTriangle); },
      [&] { terms.add(QStringLiteral("New"), 2); },
      [&] { terms.rename("near", QStringLiteral("Other")); },
      [&] { terms.remove("near", true); },
      [&] { terms.split("far", {8.5}); },
      [&] { terms.setKeepsSum(true); },
  };
  for (std::size_t way = 0; way < ways.size(); ++way) {
    terms.setExpert("");
    terms.setExpert("A");
    const QSignalSpy asked(&terms, &TermController::scopeAsked);
    ways[way]();
    EXPECT_EQ(edits.model(), tests::twoExperts()) << way;
    EXPECT_EQ(asked.count(), 1) << way;
  }
  // Another expert or variable forgets what waited.
  terms.setPoint("near", 3, 5.5);
  terms.setExpert("B");
  terms.chooseScope(true);
  EXPECT_EQ(edits.model(), tests::twoExperts());
  // The list of all says in its name that it is for all.
  terms.setExpert("");
  terms.setPoint("near", 3, 5.5);
  EXPECT_EQ(points(0)[3], 5.5);
}

TEST_F(TermControllerTest, HandlesFollowEachOther) {
  terms.selectNext(1);
  EXPECT_EQ(terms.selected(), (Grip{0, Part::kVertex, 0, false}));
  terms.selectNext(-1);
  EXPECT_EQ(terms.selected(), (Grip{1, Part::kVertex, 3, false}));
  terms.selectNext(1);
  EXPECT_EQ(terms.selected(), (Grip{0, Part::kVertex, 0, false}));
}

TEST_F(TermControllerTest, AMoveThatAnotherEditEndedDoesNotGoOn) {
  terms.beginMove({1, Part::kTerm, 0, false});
  terms.moveBy(-0.5);
  terms.remove("far", true);
  edits.begin();  // somebody else's gesture
  terms.moveBy(1);
  EXPECT_TRUE(edits.history().gestureLabel().empty());
  edits.cancel();
  EXPECT_EQ(terms.terms().size(), 1U);
}

}  // namespace
}  // namespace tactus::workbench
