#include "elicitation/agreement/expert_influence.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "elicitation/force/noticeable_force.h"

namespace tactus::elicitation {
namespace {

constexpr auto kTrapezoid = fuzzy::Shape::kTrapezoid;

/// One input x in [0, 1] with `low` up to .6 and `high` from .4; forces .2 and .8 N by symmetric terms, whose centroid
/// stays where it is at any strength.
fuzzy::ForceModel smallModel() {
  fuzzy::ForceModel model;
  model.name = "test";
  model.created_utc = "2026-11-21T08:00:00Z";
  model.generator = "test";
  model.inputs = {
      {"x", "X", "1", 0, 1, {{"low", "", kTrapezoid, {0, 0, 0.4, 0.6}}, {"high", "", kTrapezoid, {0.4, 0.6, 1, 1}}}}};
  model.output = {
      "force", "Force",
      "N",     0,
      1,       {{"small", "", kTrapezoid, {0.1, 0.2, 0.2, 0.3}}, {"large", "", kTrapezoid, {0.7, 0.8, 0.8, 0.9}}}};
  return model;
}

fuzzy::Rule rule(const char* x, const char* force) { return {{{"x", x}}, force, 1, true}; }

fuzzy::Expert expert(const char* id, std::vector<fuzzy::Rule> rules, double weight = 1) {
  return {id, id, weight, {}, std::move(rules)};
}

TEST(ExpertInfluence, OfTwoExpertsByHand) {
  auto model = smallModel();
  model.experts = {expert("A", {rule("low", "small"), rule("high", "small")}),
                   expert("B", {rule("low", "small"), rule("high", "large")})};
  const auto influences = expertInfluence(model);
  ASSERT_TRUE(influences) << influences.error().message();
  ASSERT_EQ(influences->experts.size(), 2);
  // At x >= .6 A says .2 and B says .8: the mean .5 moves by .3 with either left out.
  for (const auto& one : influences->experts) {
    ASSERT_TRUE(one.largest);
    EXPECT_NEAR(one.largest->newtons, 0.3, 1e-12);  // rounding of the centroid
    EXPECT_GE(one.largest->at.at(0), 0.6);
    EXPECT_NEAR(one.largest->noticeable, 0.3 / std::hypot(0.04, 0.12 * 0.5), 1e-11);
    EXPECT_EQ(one.share_alone, 0);
    EXPECT_TRUE(one.alone_at.empty());
  }
  // Between .4 and .6 B's sets are triangles clipped at 1 - t and t, area 2 h - h^2 each: B is .2 + .6 s with the share
  // s of the second; the mean square is .09 (∫ s^2 over the ramp / 5 + .4).
  double ramp = 0;
  constexpr int kCells = 100'000;
  for (int i = 0; i < kCells; ++i) {
    const double t = (i + 0.5) / kCells;
    const double second = 2 * t - t * t;
    const double first = 1 - t * t;
    ramp += std::pow(second / (first + second), 2) / kCells;
  }
  const double rms = std::sqrt(0.09 * (ramp / 5 + 0.4));
  EXPECT_NEAR(influences->experts[0].rms_n, rms, 2e-4);  // the middles of 256 cells
  ASSERT_EQ(influences->pairs.size(), 1);
  EXPECT_NEAR(influences->pairs[0].rms_n, 2 * rms, 4e-4);
  EXPECT_NEAR(influences->pairs[0].largest->newtons, 0.6, 1e-12);
  EXPECT_EQ(influences->pairs[0].share_both, 1);
}

TEST(ExpertInfluence, WhereOneExpertStandsAloneIsToldApart) {
  auto model = smallModel();
  model.inputs[0].terms = {{"low", "", kTrapezoid, {0, 0, 0.25, 0.25}}, {"high", "", kTrapezoid, {0.75, 0.75, 1, 1}}};
  model.experts = {expert("A", {rule("low", "small")}), expert("B", {rule("high", "large")})};
  const auto influences = expertInfluence(model);
  ASSERT_TRUE(influences);
  for (const auto& one : influences->experts) {
    EXPECT_FALSE(one.largest);
    EXPECT_EQ(one.share_alone, 0.25);
    EXPECT_EQ(one.rms_n, 0);
    EXPECT_EQ(one.alone_at.size(), 1);
  }
  EXPECT_LE(influences->experts[0].alone_at[0], 0.25);
  EXPECT_FALSE(influences->pairs[0].largest);
  EXPECT_EQ(influences->pairs[0].share_both, 0);
  EXPECT_TRUE(influenceNotes(model, *influences).empty());
}

TEST(ExpertInfluence, AnExpertOfWeightZeroChangesNothing) {
  auto model = smallModel();
  model.experts = {expert("A", {rule("low", "small"), rule("high", "small")}),
                   expert("B", {rule("low", "large"), rule("high", "large")}, 0)};
  const auto influences = expertInfluence(model);
  ASSERT_TRUE(influences);
  EXPECT_EQ(influences->experts[0].share_alone, 1) << "the others have no weight";
  EXPECT_EQ(influences->experts[1].largest->newtons, 0);
  EXPECT_NEAR(influences->pairs[0].largest->newtons, 0.6, 1e-12);
}

TEST(ExpertInfluence, UsesTheWeightsAndTheExpertsOwnTerms) {
  auto model = smallModel();
  model.experts = {expert("A", {rule("low", "small"), rule("high", "small")}, 3),
                   expert("B", {rule("low", "large"), rule("high", "large")})};
  model.experts[1].overrides = {{"x", {{"low", "", kTrapezoid, {0, 0, 1, 1}}, {"high", "", kTrapezoid, {0, 0, 1, 1}}}}};
  const auto influences = expertInfluence(model);
  ASSERT_TRUE(influences);
  // The mean is .2 + .6 / 4; without A it is .8, without B .2.
  EXPECT_NEAR(influences->experts[0].largest->newtons, 0.45, 1e-12);
  EXPECT_NEAR(influences->experts[1].largest->newtons, 0.15, 1e-12);
  EXPECT_NEAR(influences->experts[0].rms_n, 0.45, 1e-12);
}

TEST(ExpertInfluence, NotesWhoMovesTheMeanByMoreThanTwoNoticeableDifferences) {
  auto model = smallModel();
  model.experts = {expert("A", {rule("low", "small"), rule("high", "small")}),
                   expert("B", {rule("low", "small"), rule("high", "large")})};
  const auto notes = influenceNotes(model, expertInfluence(model).value());
  ASSERT_EQ(notes.size(), 2);
  EXPECT_EQ(notes[0],
            "Without expert A the averaged force would change by 0.30 N, 4.2 just-noticeable differences, at x 0.6.");
  model.experts.push_back(expert("C", {rule("low", "small"), rule("high", "small")}));
  model.experts.push_back(expert("D", {rule("low", "small"), rule("high", "small")}));
  // Four experts: the mean .35 moves by .15 without B (2.6 differences), by .05 without another.
  const auto fewer = influenceNotes(model, expertInfluence(model).value());
  ASSERT_EQ(fewer.size(), 1);
  EXPECT_EQ(fewer[0].find("Without expert B "), 0U) << fewer[0];
}

TEST(ExpertInfluence, ABrokenModelIsRefused) { EXPECT_FALSE(expertInfluence(smallModel())); }

TEST(NoticeableForce, JoinsThresholdAndWeberFraction) {
  EXPECT_DOUBLE_EQ(justNoticeableDifference(0), 0.04);
  EXPECT_NEAR(justNoticeableDifference(0.25), 0.05, 1e-15);  // sides 0.04 and 0.03; rounding only
}

// The sum of these weights is beyond double; only their ratio counts.
TEST(ExpertInfluence, OfExpertsWithHugeWeights) {
  auto model = smallModel();
  for (const double weight : {1.0, 1.5e308}) {
    model.experts = {expert("A", {rule("low", "small"), rule("high", "small")}, weight),
                     expert("B", {rule("low", "small"), rule("high", "large")}, weight)};
    const auto influences = expertInfluence(model);
    ASSERT_TRUE(influences) << influences.error().message();
    ASSERT_TRUE(influences->experts[0].largest);
    EXPECT_NEAR(influences->experts[0].largest->newtons, 0.3, 1e-12);  // rounding of the centroid
  }
}

}  // namespace
}  // namespace tactus::elicitation
