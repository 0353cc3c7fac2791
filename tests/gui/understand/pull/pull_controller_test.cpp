#include "app/workbench/understand/pull/pull_controller.h"

#include <QSignalSpy>
#include <QTest>
#include <cmath>
#include <gtest/gtest.h>

#include "app/editing/edit.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/scene_controller.h"
#include "core/analysis/pull/pull_text.h"

#include "tests/gui/patience.h"
#include "tests/gui/sample_models.h"
#include "tests/support/ngt_model.h"

namespace tactus::workbench {
namespace {

using State = PullController::State;

constexpr std::size_t kNgtDepth = 2;

/// The model of the paper's expert S4 with five regions, at its reference point A: force .589444 N. The expected edits
/// are those of tests/core/analysis/pull/pull_test.cpp, which come from another program.
class PullControllerTest : public testing::Test {
 protected:
  void SetUp() override {
    models.open(folder.write(support::s4FiveRegions()));
    scene.setXInput(kNgtDepth);
    scene.goTo({1, 60, 200, 50});
  }

  void pullTo(double force_n) {
    pull.begin(pointWish(200, force_n), std::nullopt, State::kChoosing);
    wait();
  }
  void wait() {
    ASSERT_TRUE(QTest::qWaitFor([this] { return pull.answer() != nullptr && !pull.isSearching(); }, tests::kPatience));
  }
  double forceHere() const { return models.current()->compiled.evaluate(std::vector<double>{1, 60, 200, 50}).force_n; }

  tests::ModelFolder folder;
  ModelController models;
  SceneController scene{models};
  EditController edits{models};
  std::vector<editing::VertexPlace> locked;
  PullController pull{edits, scene, [this] { return locked; }};
};

TEST_F(PullControllerTest, OffersTheBestEditOfEachKindAndChangesNothing) {
  pullTo(.55);
  const PullAnswer& answer = *pull.answer();
  ASSERT_TRUE(answer.now_n && answer.reach);
  EXPECT_NEAR(*answer.now_n, .589444, 5e-7);
  EXPECT_LE(answer.reach->min_n, .55);
  EXPECT_GE(answer.reach->max_n, .62);
  ASSERT_FALSE(answer.offers.empty());
  EXPECT_EQ(answer.offers[0].what,
            QStringLiteral("Depth, laryngopharynx/esophagus: the transition ends at 202.107 instead of 215.000 mm"));
  EXPECT_EQ(answer.offers[0].price, QStringLiteral("Elsewhere the force moves by 0.09 JND (RMS), at most 0.159 N."));
  std::size_t plausible = 0;
  for (const PullOffer& offer : answer.offers) plausible += offer.folded ? 0 : 1;
  EXPECT_LE(plausible, 3U);
  EXPECT_EQ(edits.model(), support::s4FiveRegions());
  EXPECT_FALSE(edits.canUndo());
}

TEST_F(PullControllerTest, TheCurveOfAnOfferIsThatOfTheEditedModel) {
  pullTo(.55);
  for (const PullOffer& offer : pull.answer()->offers) {
    const auto after = fuzzy::compile(analysis::applied(edits.model(), offer.edits));
    ASSERT_TRUE(after);
    ASSERT_EQ(offer.x.size(), offer.curve.size());
    for (std::size_t i = 0; i < offer.x.size(); i += 97) {
      const auto force = after->evaluateExpert(0, std::vector<double>{1, 60, offer.x[i], 50});
      EXPECT_EQ(offer.curve[i].fired, force.fired);
      EXPECT_NEAR(offer.curve[i].force_n, force.force_n, 1e-12) << "the mean of one expert";
    }
  }
}

TEST_F(PullControllerTest, TakingAnOfferIsOneStepOfUndo) {
  pullTo(.55);
  pull.take(0);
  EXPECT_EQ(pull.state(), State::kIdle);
  EXPECT_NEAR(forceHere(), .55, 1e-9);
  ASSERT_TRUE(edits.canUndo());
  edits.undo();
  EXPECT_NEAR(forceHere(), .589444, 5e-7);
  EXPECT_FALSE(edits.canUndo());
}

TEST_F(PullControllerTest, ADragSeeksTheBestEditAlone) {
  pull.begin(pointWish(200, .58), std::nullopt, State::kPulling);
  for (const double wanted : {.57, .56, .55}) {
    PullWish wish = pull.wish();
    wish.force_n = wanted;
    pull.setWish(wish);
  }
  wait();
  ASSERT_EQ(pull.answer()->offers.size(), 1U);
  EXPECT_TRUE(pull.answer()->offers[0].what.contains(QStringLiteral("ends at 202.107")))
      << "the last wish: " << pull.answer()->offers[0].what.toStdString();
  pull.take(0);
  EXPECT_EQ(pull.state(), State::kPulling) << "nothing is taken before the user chooses";
  pull.choose();
  wait();
  EXPECT_GT(pull.answer()->offers.size(), 1U);
}

TEST_F(PullControllerTest, ALockedVertexIsNotMoved) {
  locked = {{{"depth", ""}, "laryngopharynx", 3}};
  pullTo(.55);
  for (const PullOffer& offer : pull.answer()->offers)
    EXPECT_FALSE(offer.what.contains(QStringLiteral("ends at 202.107"))) << offer.what.toStdString();
  EXPECT_EQ(pull.lockedVertices(), 1U);
}

// A pin holds the force within a quarter of a noticeable difference (sqrt(0.04^2 + (0.12 F)^2)) in each offer.
TEST_F(PullControllerTest, APinnedForceStays) {
  const std::vector<double> pin = {1, 60, 208, 50};
  const double before_n = models.current()->compiled.evaluate(pin).force_n;
  const double held_n = std::hypot(.04, .12 * before_n) / 4;
  const auto moved_n = [&](const PullOffer& offer) {
    return std::abs(fuzzy::compile(analysis::applied(edits.model(), offer.edits))->evaluate(pin).force_n - before_n);
  };
  pullTo(.55);
  const auto& free = pull.answer()->offers;
  EXPECT_TRUE(std::any_of(free.begin(), free.end(), [&](const auto& offer) { return moved_n(offer) > held_n; }));
  pull.togglePin(pin);
  wait();
  for (const PullOffer& offer : pull.answer()->offers) EXPECT_LE(moved_n(offer), held_n + 1e-9);
  EXPECT_EQ(pull.pins().size(), 1U);
  pull.togglePin(pin);
  EXPECT_TRUE(pull.pins().empty());
}

TEST_F(PullControllerTest, APinNeedsAForceAndGoesWithItsModel) {
  auto holed = support::s4FiveRegions();
  holed.experts[0].rules = {{{{"speed", "fast"}}, "large"}};
  models.open(folder.write(holed, QStringLiteral("holed.tactus.json")));
  QSignalSpy refused(&edits, &EditController::refused);
  pull.togglePin({1, 60, 200, 0});
  EXPECT_TRUE(pull.pins().empty());
  EXPECT_EQ(refused.count(), 1);
  pull.togglePin({1, 60, 200, 300});
  EXPECT_EQ(pull.pins().size(), 1U);
  models.open(folder.write(tests::twoExperts(), QStringLiteral("other.tactus.json")));
  EXPECT_TRUE(pull.pins().empty());
}

TEST_F(PullControllerTest, AnAnswerThatIsContradictedIsNamed) {
  pullTo(.62);
  bool rules = false;
  for (const PullOffer& offer : pull.answer()->offers) {
    if (!analysis::editsRule(offer.edits[0].gesture)) continue;
    rules = true;
    EXPECT_TRUE(offer.notes.contains(QStringLiteral("Contradicts the answer of S4.")))
        << offer.notes.join(QLatin1Char('|')).toStdString();
  }
  EXPECT_TRUE(rules);
}

TEST_F(PullControllerTest, WhatIsOutOfReachSaysWhyAndHowFarItGoes) {
  pull.begin(pointWish(300, 1.0), std::nullopt, State::kChoosing);
  wait();
  EXPECT_TRUE(pull.answer()->sentence.startsWith(QStringLiteral("No edit gives 1.000 N: ")))
      << pull.answer()->sentence.toStdString();
  EXPECT_TRUE(pull.answer()->sentence.contains(QStringLiteral("One edit reaches")));
}

TEST_F(PullControllerTest, ABandOverAStretch) {
  pull.begin(bandWish(125, 185, .50, 1.1), std::nullopt, State::kChoosing);
  wait();
  ASSERT_FALSE(pull.answer()->offers.empty());
  pull.take(*pull.previewed());
  double lowest = 1;
  for (double depth = 125; depth <= 185; depth += 1) {
    lowest = std::min(lowest, models.current()->compiled.evaluate(std::vector<double>{1, 60, depth, 50}).force_n);
  }
  const double before = fuzzy::compile(support::s4FiveRegions())->evaluate(std::vector<double>{1, 60, 150, 50}).force_n;
  EXPECT_GT(lowest, before) << "0.468 N at 150 mm before";
}

TEST_F(PullControllerTest, ACurveFromAFile) {
  PullWish wish{PullWish::Kind::kReference, 0, 0, 0, 0, 0, QStringLiteral("measured"), {}, {}};
  auto shifted = support::s4FiveRegions();
  const auto there =
      analysis::applied(shifted, std::vector{[] {
                          analysis::PullEdit edit = analysis::termEdit(analysis::Gesture::kShift, {kNgtDepth, {}}, 2);
                          edit.delta = 8;
                          return edit;
                        }()});
  const auto compiled = fuzzy::compile(there);
  for (double depth = 0; depth <= 600; depth += 2) {
    wish.x.push_back(depth);
    wish.y_n.push_back(compiled->evaluate(std::vector<double>{1, 60, depth, 50}).force_n);
  }
  pull.begin(wish, std::nullopt, State::kChoosing);
  wait();
  ASSERT_FALSE(pull.answer()->offers.empty());
  EXPECT_NEAR(pull.answer()->offers[0].edits[0].delta, 8, 1e-3);
}

TEST_F(PullControllerTest, EndsWhereTheModelOrTheSceneChanges) {
  pullTo(.55);
  scene.setValue(kNgtDepth, 120);
  EXPECT_EQ(pull.state(), State::kChoosing) << "the place of the pull is its own";
  scene.setValue(0, .5);
  EXPECT_EQ(pull.state(), State::kIdle);

  pullTo(.55);
  auto model = edits.model();
  model.experts[0].rules[0].then = "large";
  ASSERT_TRUE(edits.apply(editing::finished(std::move(model), "a rule")));
  EXPECT_EQ(pull.state(), State::kIdle);
}

TEST_F(PullControllerTest, WhoApprovedIsNamed) {
  edits.signOff(QStringLiteral("S4"));
  pullTo(.55);
  EXPECT_EQ(pull.approvedBy(), QStringList{QStringLiteral("S4")});
}

}  // namespace
}  // namespace tactus::workbench
