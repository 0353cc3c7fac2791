#include "app/workbench/tune/history/carry_controller.h"

#include <QSignalSpy>
#include <gtest/gtest.h>

#include "app/editing/membership_edits.h"
#include "app/editing/rule_edits.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/model_controller.h"

#include "tests/gui/sample_models.h"
#include "tests/gui/sample_study.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;
using tests::kNearShoulder;
using Outcome = editing::CarriedEdit::Outcome;

/// The sample model was tuned in two edits and built anew.
class CarryControllerTest : public testing::Test {
 protected:
  void SetUp() override {
    models.open(folder.write(built(tests::twoExperts(), "2026-11-21T08:00:00Z")));
    ASSERT_TRUE(edits.apply(editing::moveVertex(edits.model(), kNearShoulder, 3)));
    ASSERT_TRUE(edits.apply(editing::setExpertWeight(edits.model(), "B", 0.5)));
    edits.snapshot(QStringLiteral("my tuned version"));
    tuned = edits.history().current();
  }

  static fuzzy::ForceModel built(fuzzy::ForceModel model, const char* when) {
    model.created_utc = when;
    return model;
  }
  void buildAnew(fuzzy::ForceModel model) {
    ASSERT_TRUE(edits.apply(editing::finished(built(std::move(model), "2026-11-28T08:00:00Z"), "Built anew")));
  }
  void list(editing::StateId state) {
    carry.begin(state);
    carry.list().hold(holder);
    carry.sum().hold(holder);
    ASSERT_TRUE(comesTrue([this] { return !carry.list().isBusy() && !carry.sum().isBusy(); }));
  }
  const CarryRow* row(const std::string& what) const {
    for (const CarryRow& one : carry.rows()) {
      if (one.content.what.find(what) != std::string::npos) return &one;
    }
    return nullptr;
  }

  tests::ModelFolder folder;
  ModelController models;
  EditController edits{models};
  std::vector<editing::VertexPlace> locks;
  CarryController carry{edits, [this] { return locks; }, [] { return CurveSetting(); }};
  QObject holder;
  editing::StateId tuned = 0;
};

TEST_F(CarryControllerTest, FindsTheVersionThatWasTunedBeforeTheBuild) {
  EXPECT_FALSE(carry.earlier());  // the open model is that version
  buildAnew(tests::twoExperts());
  ASSERT_TRUE(carry.earlier());
  EXPECT_EQ(carry.earlier()->state, tuned);
  EXPECT_EQ(carry.earlier()->edits, 2U);
  // Built once more without an edit in between: the edits are still those.
  fuzzy::ForceModel third = built(tests::twoExperts(), "2026-11-29T08:00:00Z");
  ASSERT_TRUE(edits.apply(editing::finished(third, "Built once more")));
  ASSERT_TRUE(carry.earlier());
  EXPECT_EQ(carry.earlier()->state, tuned);
}

TEST_F(CarryControllerTest, ComputesNothingUntilItIsLookedAt) {
  buildAnew(tests::twoExperts());
  carry.begin(tuned);
  EXPECT_FALSE(carry.list().isBusy());
  EXPECT_TRUE(carry.rows().empty());
}

TEST_F(CarryControllerTest, TheEditsBecomeOneStep) {
  buildAnew(tests::twoExperts());
  const editing::StateId anew = edits.history().current();
  list(tuned);
  ASSERT_EQ(carry.rows().size(), 2U);
  EXPECT_EQ(carry.source(), QStringLiteral("my tuned version"));
  for (const CarryRow& one : carry.rows()) {
    EXPECT_TRUE(one.chosen);
    ASSERT_TRUE(one.price) << one.content.what;
  }
  EXPECT_GT(row("share in the mean")->price->largest_n, 0);
  ASSERT_NE(carry.together(), nullptr);
  ASSERT_TRUE(carry.carry());
  EXPECT_EQ(edits.history().states()[edits.history().current()].parent, anew);
  EXPECT_EQ(edits.model().inputs[1].terms[0].points[2], 3);
  EXPECT_EQ(edits.model().experts[1].weight, 0.5);
  EXPECT_EQ(edits.model().created_utc, "2026-11-28T08:00:00Z");
  EXPECT_FALSE(carry.isActive());
  edits.undo();
  EXPECT_EQ(edits.history().current(), anew);
}

TEST_F(CarryControllerTest, AConflictIsNotChosenUntilTheUserChoosesIt) {
  fuzzy::ForceModel target = tests::twoExperts();
  target.experts[1].weight = 2;
  buildAnew(target);
  list(tuned);
  const CarryRow* weight = row("share in the mean");
  ASSERT_NE(weight, nullptr);
  EXPECT_EQ(weight->content.outcome, Outcome::kConflict);
  EXPECT_FALSE(weight->chosen);
  EXPECT_EQ(carry.chosenCount(), 1U);
  carry.chooseAll(true);
  EXPECT_EQ(carry.chosenCount(), 2U);
  ASSERT_TRUE(comesTrue([this] { return carry.together() != nullptr; }));
  ASSERT_TRUE(carry.carry());
  EXPECT_EQ(edits.model().experts[1].weight, 0.5);
}

TEST_F(CarryControllerTest, WhatIsLockedOrGoneIsNamedAndStandsLast) {
  locks = {kNearShoulder};
  fuzzy::ForceModel target = tests::twoExperts();
  buildAnew(target);
  list(tuned);
  ASSERT_EQ(carry.rows().size(), 2U);
  const CarryRow& last = carry.rows().back();
  EXPECT_EQ(last.content.outcome, Outcome::kDoesNotApply);
  EXPECT_NE(last.content.note.find("is locked"), std::string::npos);
  EXPECT_FALSE(last.price);
  carry.choose(1, true);
  EXPECT_FALSE(carry.rows()[1].chosen);
  ASSERT_TRUE(carry.carry());
  EXPECT_EQ(edits.model().inputs[1].terms[0].points[2], tests::twoExperts().inputs[1].terms[0].points[2]);
}

TEST_F(CarryControllerTest, TheGhostIsTheModelWithTheEdit) {
  buildAnew(tests::twoExperts());
  list(tuned);
  std::shared_ptr<const OpenModel> ghost;
  QString name;
  QObject::connect(&carry, &CarryController::previewed,
                   [&](const std::shared_ptr<const OpenModel>& model, const QString& label) {
                     ghost = model;
                     name = label;
                   });
  for (std::size_t r = 0; r < carry.rows().size(); ++r) {
    carry.preview(r);
    ASSERT_NE(ghost, nullptr);
    const bool is_weight = carry.rows()[r].content.what.find("share") != std::string::npos;
    EXPECT_EQ(ghost->model.experts[1].weight == 0.5, is_weight);
    EXPECT_TRUE(name.startsWith(QStringLiteral("With: ")));
  }
  carry.preview(std::nullopt);
  EXPECT_EQ(ghost, nullptr);
}

TEST_F(CarryControllerTest, FollowsAnEditOfTheOpenModel) {
  buildAnew(tests::twoExperts());
  list(tuned);
  ASSERT_TRUE(edits.apply(editing::moveVertex(edits.model(), kNearShoulder, 3)));
  ASSERT_TRUE(comesTrue([this] {
    const CarryRow* near = row("right shoulder");
    return near != nullptr && near->content.outcome == Outcome::kAlreadySo;
  }));
  // Another model ends it.
  models.open(folder.write(tests::twoExperts(), QStringLiteral("other.tactus.json")));
  EXPECT_FALSE(carry.isActive());
  EXPECT_TRUE(carry.rows().empty());
}

TEST_F(CarryControllerTest, ABranchOfTheSameBuildGivesWhatItAlone) {
  edits.undo();
  ASSERT_TRUE(edits.apply(editing::setExpertWeight(edits.model(), "A", 0.25)));
  list(tuned);
  // The move of the vertex is part of both.
  ASSERT_EQ(carry.rows().size(), 1U);
  EXPECT_EQ(carry.rows()[0].content.after, "0.5");
}

}  // namespace
}  // namespace tactus::workbench
