#include "app/workbench/model/ghost_controller.h"

#include <QTest>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <utility>

#include "app/editing/membership_edits.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/tune/history/compare_controller.h"
#include "core/base/random.h"

#include "tests/gui/patience.h"
#include "tests/gui/sample_models.h"

namespace tactus::workbench {
namespace {

class GhostControllerTest : public testing::Test {
 protected:
  void SetUp() override { models.open(folder.write(tests::twoExperts())); }

  /// The force for "far", which expert A says is high (0.75 N) and B low (0.25 N).
  static base::Result<editing::Edit> farSays(fuzzy::ForceModel model, const char* term) {
    model.experts[0].rules[2].then = term;
    return editing::finished(std::move(model), std::string("far is ") + term);
  }

  tests::ModelFolder folder;
  ModelController models;
  SceneController scene{models};
  EditController edits{models};
  GhostController ghost{edits, scene};
};

TEST_F(GhostControllerTest, AFreshModelHasNone) {
  EXPECT_EQ(ghost.before(), nullptr);
  EXPECT_EQ(ghost.curves(), nullptr);
  EXPECT_EQ(ghost.differenceText(), QString());
}

TEST_F(GhostControllerTest, StandsForTheModelBeforeTheLastEdit) {
  ASSERT_TRUE(edits.apply(farSays(edits.model(), "low")));
  ASSERT_NE(ghost.before(), nullptr);
  EXPECT_EQ(ghost.before()->model, tests::twoExperts());
  EXPECT_EQ(ghost.whatChanged(), QStringLiteral("far is low"));
  const GhostCurves* curves = ghost.curves();
  ASSERT_NE(curves, nullptr);
  EXPECT_DOUBLE_EQ(curves->mean.back().force_n, 0.5);
  EXPECT_DOUBLE_EQ(curves->experts[0].back().force_n, 0.75);
  // The mean of 0.75 N and 0.25 N was 0.5 N and is 0.25 N now; JND(0.5 N) = sqrt(0.04^2 + 0.06^2) = 0.0721 N.
  EXPECT_NEAR(curves->difference.largest_n, 0.25, 1e-12);
  EXPECT_NEAR(curves->difference.noticeable, 0.25 / std::sqrt(0.0016 + 0.0036), 1e-9);
  EXPECT_GE(*curves->difference.largest_at, 6);
  EXPECT_TRUE(ghost.differenceText().startsWith(QStringLiteral("max ΔF anywhere at least 0.250 N (3.5 JND) at ")))
      << ghost.differenceText().toStdString();
}

TEST_F(GhostControllerTest, InAGestureItIsTheBeginningOfIt) {
  ASSERT_TRUE(edits.apply(farSays(edits.model(), "low")));
  const fuzzy::ForceModel first = edits.model();
  edits.begin();
  ASSERT_TRUE(edits.update(farSays(edits.base(), "high")));
  // A gesture is shown at the next frame of the screen.
  EXPECT_TRUE(QTest::qWaitFor([&] { return ghost.before()->model == first; }, tests::kPatience));
  edits.cancel();
  EXPECT_EQ(ghost.before()->model, tests::twoExperts());
}

TEST_F(GhostControllerTest, FollowsUndoRedoAndOpening) {
  ASSERT_TRUE(edits.apply(farSays(edits.model(), "low")));
  const fuzzy::ForceModel first = edits.model();
  fuzzy::ForceModel second = first;
  second.experts[1].rules[0].then = "high";
  ASSERT_TRUE(edits.apply(editing::finished(second, "B too")));
  EXPECT_EQ(ghost.before()->model, first);
  edits.undo();
  EXPECT_EQ(ghost.before()->model, tests::twoExperts());
  edits.undo();
  EXPECT_EQ(ghost.before(), nullptr);
  edits.redo();
  EXPECT_EQ(ghost.before()->model, tests::twoExperts());
  models.reopen();
  EXPECT_EQ(ghost.before(), nullptr);
}

TEST_F(GhostControllerTest, AReferenceTakesItsPlaceUntilItIsCleared) {
  ASSERT_TRUE(edits.apply(farSays(edits.model(), "low")));
  const auto other = models.current();
  ASSERT_TRUE(edits.apply(farSays(edits.model(), "high")));
  ASSERT_TRUE(ghost.setReference(other, QStringLiteral("Version of Monday")).has_value());
  EXPECT_EQ(ghost.label(), QStringLiteral("Version of Monday"));
  EXPECT_EQ(ghost.before(), other);
  ghost.clearReference();
  EXPECT_EQ(ghost.label(), QStringLiteral("Before the last edit"));

  fuzzy::ForceModel wider = other->model;
  wider.inputs[1].max = 11;
  const auto strange = std::make_shared<const OpenModel>(editing::ready(wider).value());
  EXPECT_FALSE(ghost.setReference(strange, QStringLiteral("other")).has_value());
  ASSERT_TRUE(ghost.setReference(other, QStringLiteral("again")).has_value());
  models.reopen();
  EXPECT_FALSE(ghost.hasReference());
}

TEST_F(GhostControllerTest, SwitchedOffItComputesNothing) {
  ghost.setOn(false);
  ASSERT_TRUE(edits.apply(farSays(edits.model(), "low")));
  const std::uint64_t before = scene.evaluations();
  EXPECT_EQ(ghost.curves(), nullptr);
  EXPECT_EQ(ghost.differenceText(), QString());
  EXPECT_EQ(scene.evaluations(), before);
  ghost.setOn(true);
  EXPECT_NE(ghost.curves(), nullptr);
}

TEST_F(GhostControllerTest, FollowsTheSetting) {
  ASSERT_TRUE(edits.apply(farSays(edits.model(), "low")));
  scene.setXInput(0);  // along speed, at a depth of "near" the edit does nothing
  scene.setValue(1, 2);
  EXPECT_EQ(ghost.differenceText(),
            QStringLiteral("No change here: acts at Depth 6 to 10 mm · max ΔF anywhere at least 0.250 N (3.5 JND)"));
  // Going there shows it.
  ASSERT_TRUE(ghost.elsewhere().has_value());
  scene.goTo(ghost.elsewhere()->at);
  EXPECT_FALSE(ghost.elsewhere().has_value());
  EXPECT_NEAR(ghost.curves()->difference.largest_n, 0.25, 1e-12);
  scene.setValue(1, 8);
  EXPECT_NEAR(ghost.curves()->difference.largest_n, 0.25, 1e-12);
}

TEST_F(GhostControllerTest, AHoleThatClosesIsAChange) {
  // Nobody speaks at depths from 5 to 6 mm until "near" reaches to 5.5 mm; elsewhere nothing moves.
  fuzzy::ForceModel model = tests::twoExperts();
  model.inputs[1].terms[0].points = {0, 0, 5, 5.5};
  ASSERT_TRUE(edits.apply(editing::finished(model, "near reaches farther")));
  scene.setValue(0, 20);
  EXPECT_EQ(ghost.differenceText(), QStringLiteral("fills a hole"));
  ASSERT_TRUE(edits.apply(editing::finished(tests::twoExperts(), "and back")));
  EXPECT_EQ(ghost.differenceText(), QStringLiteral("leaves a hole"));
}

TEST_F(GhostControllerTest, TheMostNoticeableChangeMayBeAtAnotherPlace) {
  fuzzy::ForceModel model = tests::twoExperts();
  const auto rectangle = [](const char* id, double middle) {
    return fuzzy::Term{id, id, fuzzy::Shape::kTrapezoid, {middle - 0.1, middle - 0.1, middle + 0.1, middle + 0.1}};
  };
  model.output.terms.push_back(rectangle("low_more", 0.45));
  model.output.terms.push_back(rectangle("low_much_more", 0.69));
  model.experts[0].rules[0].then = "low_more";
  model.experts[1].rules[0].then = "low_much_more";
  ASSERT_TRUE(edits.apply(editing::finished(model, "both")));
  scene.setValue(0, 20);
  // Near: 0.2 N from 0.25 N, 0.2 / sqrt(0.0016 + 0.0009) = 4 JND. Far: 0.22 N from 0.5 N, 3.1 JND.
  EXPECT_TRUE(ghost.differenceText().startsWith(
      QStringLiteral("max ΔF anywhere at least 0.220 N (4 JND) · on this curve at least 0.220 N at ")));
  EXPECT_TRUE(ghost.differenceText().contains(QStringLiteral(", 4 JND at "))) << ghost.differenceText().toStdString();
}

// One number for one edit: the history, the legend and the comparison never say less than the curve on the screen
// shows.
TEST_F(GhostControllerTest, NoNumberIsSmallerThanTheCurveShows) {
  base::Random random(3);
  CompareController compare(models, edits, [this] { return CurveSetting{scene.xInput(), scene.values()}; });
  for (int i = 0; i < 40; ++i) {
    const fuzzy::ForceModel now = edits.model();
    const double to = now.inputs[1].terms[1].points[0] + random.uniform(-0.7, 0.7);
    edits.apply(editing::moveVertex(now, {{"depth", ""}, "far", 0}, to));
    ASSERT_TRUE(QTest::qWaitFor([&] { return scene.model()->model == edits.model(); }, 10'000));
    scene.setXInput(static_cast<std::size_t>(random.below(2)));
    for (std::size_t k = 0; k < now.inputs.size(); ++k) {
      scene.setValue(k, random.uniform(now.inputs[k].min, now.inputs[k].max));
    }
    const GhostCurves* curves = ghost.curves();
    if (curves == nullptr) continue;
    const auto state = edits.history().current();
    const auto impact = edits.impactOf(state);
    ASSERT_TRUE(impact.has_value());
    EXPECT_GE(impact->largest_n, curves->difference.largest_n);
    EXPECT_GE(impact->noticeable, curves->difference.noticeable);
    if (curves->difference.largest_n == 0) continue;
    // What begins the legend is what the history says.
    const QString effect = edits.effectOf(state);
    EXPECT_TRUE(ghost.differenceText().startsWith(effect.section(QStringLiteral(" · "), 0, 0)))
        << ghost.differenceText().toStdString() << " against " << effect.toStdString();
    // A report of the edit makes the result unknown again.
    const auto known = [&] {
      compare.compute();
      return compare.result().has_value();
    };
    ASSERT_TRUE(QTest::qWaitFor(known, 10'000));
    EXPECT_DOUBLE_EQ(compare.result()->largest_n, impact->largest_n);
  }
}

TEST_F(GhostControllerTest, NewtonsAloneAreNoticed) {
  fuzzy::ForceModel model = tests::twoExperts();
  model.output.unit = "mN";
  models.open(folder.write(model, QStringLiteral("other.tactus.json")));
  model.experts[0].rules[2].then = "low";
  ASSERT_TRUE(edits.apply(editing::finished(model, "far is low")));
  EXPECT_TRUE(ghost.differenceText().startsWith(QStringLiteral("max ΔF anywhere at least 0.250 mN at ")))
      << ghost.differenceText().toStdString();
  EXPECT_FALSE(ghost.differenceText().contains(QStringLiteral("JND")));
}

}  // namespace
}  // namespace tactus::workbench
