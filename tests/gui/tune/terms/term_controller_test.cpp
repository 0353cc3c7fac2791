#include "app/workbench/tune/terms/term_controller.h"

#include <QSignalSpy>
#include <algorithm>
#include <gtest/gtest.h>

#include "app/editing/partition.h"
#include "core/base/random.h"
#include "core/fuzzy/validate.h"

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

/// A hand that does anything, in any order.
class RandomHand {
 public:
  RandomHand(EditController& edits, TermController& terms, std::uint64_t seed)
      : edits_(edits), terms_(terms), random_(seed) {}

  void act() {
    const std::size_t count = terms_.terms().size();
    const std::size_t t = pick(count);
    const std::string id = terms_.terms()[t].id;
    const double range = terms_.variable().max - terms_.variable().min;
    const double place = terms_.variable().min + range * random_.uniform(-0.2, 1.2);
    switch (pick(20)) {
      case 0: {
        const auto& model = terms_.model();
        const std::size_t v = pick(model.inputs.size() + 1);
        terms_.setVariable(v == model.inputs.size() ? model.output.id : model.inputs[v].id);
        break;
      }
      case 1:
        terms_.setExpert(pick(2) == 0 ? "" : terms_.model().experts[pick(2)].id);
        terms_.chooseScope(pick(2) == 0);
        break;
      case 2:
        terms_.setKeepsSum(pick(2) == 0);
        break;
      case 3:
        terms_.setLocked(id, pick(4), pick(3) == 0);
        break;
      case 4:
        terms_.convert(id, fuzzy::kShapes[pick(3)]);
        break;
      case 5:
        if (count < 12) terms_.add(QStringLiteral("New"), place);
        break;
      case 6:
        terms_.remove(id, pick(4) == 0);
        break;
      case 7:
        if (count < 12) terms_.split(id, {place});
        break;
      case 8:
        terms_.rename(id, QStringLiteral("Name %1").arg(pick(100)));
        break;
      case 9:
        terms_.setOwnList(pick(2) == 0);
        break;
      case 10:
        terms_.setPoint(id, pick(4), place);
        break;
      case 11:
        edits_.undo();
        break;
      case 12:
        edits_.redo();
        break;
      case 13:
        terms_.selectNext(pick(2) == 0 ? 1 : -1);
        break;
      case 14:
      case 15:
        for (std::size_t i = pick(6) + 1; i > 0; --i) terms_.step(pick(2) == 0 ? 1 : -1, pick(3) == 0);
        if (pick(3) != 0) terms_.endSteps();
        break;
      default:
        dragSomething(t, range);
        break;
    }
  }

 private:
  std::size_t pick(std::size_t count) { return static_cast<std::size_t>(random_.below(static_cast<int>(count))); }

  void dragSomething(std::size_t t, double range) {
    const std::size_t part = pick(7);
    Grip grip{t, Part::kVertex, part, false};
    if (part == 4) grip = {t, Part::kLeftEdge, 0, false};
    if (part == 5) grip = {t, Part::kRightEdge, 0, false};
    if (part == 6) grip = {t, Part::kTerm, 0, false};
    if (!holds(terms_.terms(), grip)) return;
    terms_.beginMove(grip);
    for (std::size_t i = pick(8) + 1; i > 0; --i) terms_.moveBy(range * random_.uniform(-0.5, 0.5));
    switch (pick(6)) {
      case 0:
        terms_.cancelMove();
        break;
      case 1:
        edits_.undo();  // Ctrl+Z while the button is down
        terms_.endMove();
        break;
      default:
        terms_.endMove();
        break;
    }
  }

  EditController& edits_;
  TermController& terms_;
  base::Random random_;
};

TEST_F(TermControllerTest, NoHandMakesAnInvalidModelAndUndoReturnsExactly) {
  RandomHand hand(edits, terms, 7);
  constexpr int kActs = 4000;
  for (int i = 0; i < kActs; ++i) {
    hand.act();
    const auto valid = fuzzy::validate(edits.model());
    ASSERT_TRUE(valid.has_value()) << "act " << i << ": " << valid.error().message();
  }
  terms.endSteps();
  EXPECT_EQ(models.current()->model, edits.model());
  while (edits.canUndo()) edits.undo();
  EXPECT_EQ(edits.model(), tests::twoExperts());
  EXPECT_EQ(models.current()->model, tests::twoExperts());
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
