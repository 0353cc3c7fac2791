#include "core/analysis/pull/pull_curve.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "core/analysis/pull/force_search.h"
#include "core/base/random.h"

#include "tests/core/analysis/ngt_numbers.h"
#include "tests/support/invented_experts.h"
#include "tests/support/ngt_model.h"

namespace tactus::analysis {
namespace {

enum PlantedIn : std::size_t { kInFlexion = 1, kInDepth = 2, kInForce = 4 };

ReferenceCurve emptyCurve() { return {std::vector<std::vector<double>>(4), {}, {}}; }

void addPoint(ReferenceCurve& curve, double depth_mm, double low_n, double high_n) {
  const double point[] = {1, 60, depth_mm, 50};
  for (std::size_t i = 0; i < 4; ++i) curve.columns[i].push_back(point[i]);
  curve.low_n.push_back(low_n);
  curve.high_n.push_back(high_n);
}

/// The force of `model` at depths 0, 2, … 600, or in other steps.
ReferenceCurve curveOf(const fuzzy::ForceModel& model, int step_mm = 2) {
  const auto compiled = fuzzy::compile(model);
  ReferenceCurve curve = emptyCurve();
  for (int depth_mm = 0; depth_mm <= 600; depth_mm += step_mm) {
    const double point[] = {1, 60, static_cast<double>(depth_mm), 50};
    const double force_n = compiled->evaluate(point).force_n;
    addPoint(curve, depth_mm, force_n, force_n);
  }
  return curve;
}

/// Moves the ramp between two terms of an input, of a list that sums to one in the order of its terms.
void plant(fuzzy::Variable& variable, std::size_t ramp, double begin, double end) {
  variable.terms[ramp].points[2] += begin;
  variable.terms[ramp].points[3] += end;
  variable.terms[ramp + 1].points[0] += begin;
  variable.terms[ramp + 1].points[1] += end;
}

class PullCurveTest : public testing::Test {
 protected:
  void pullTo(const ReferenceCurve& curve, std::size_t box_points = kBoxPoints) {
    PullSettings settings;
    settings.box_points = box_points;
    const auto found = pullToCurve(model_, point_, curve, noticeable, settings);
    ASSERT_TRUE(found.has_value()) << found.error().message();
    found_ = *found;
  }

  const CurveCandidate* find(std::size_t variable, Gesture gesture) const {
    for (const CurveCandidate& one : found_.candidates) {
      const PullEdit& edit = one.candidate.edits[0];
      if (editsRule(edit.gesture) || one.candidate.edits.size() > 1) continue;
      if (edit.list.variable == variable && edit.gesture == gesture) return &one;
    }
    return nullptr;
  }

  const CurveCandidate* rule(std::size_t number, Gesture gesture, const std::string& then = {}) const {
    for (const CurveCandidate& one : found_.candidates) {
      const PullEdit& edit = one.candidate.edits[0];
      if (edit.gesture == gesture && edit.rule + 1 == number && edit.then == then && one.candidate.edits.size() == 1)
        return &one;
    }
    return nullptr;
  }

  fuzzy::ForceModel model_ = support::s4FiveRegions();
  std::vector<double> point_ = {1, 60, 200, 50};
  CurvePull found_;
};

// The numbers of the planted gestures, and the residuals of the next best, are those of another program.
TEST_F(PullCurveTest, APlantedShiftInDepthIsFound) {
  auto planted = model_;
  plant(planted.inputs[kInDepth], 2, 8, 8);
  pullTo(curveOf(planted));
  ASSERT_GE(found_.candidates.size(), 2U);
  const CurveCandidate& best = found_.candidates[0];
  EXPECT_EQ(best.candidate.edits[0].gesture, Gesture::kShift);
  EXPECT_NEAR(best.candidate.edits[0].delta, 8, 1e-9) << "the rounding of 600 mm, magnified by golden sections";
  EXPECT_LT(best.residual_n, 1e-12);
  EXPECT_EQ(best.same_curve, 0U);
  EXPECT_TRUE(best.candidate.exact);
  EXPECT_TRUE(found_.close);
  EXPECT_EQ(found_.candidates[1].candidate.edits[0].gesture, Gesture::kWiden);
  EXPECT_NEAR(found_.candidates[1].residual_n, .00258, 5.1e-6) << "printed with five digits";
}

TEST_F(PullCurveTest, OneCurveDoesNotTellTheGesturesOfAConditionApart) {
  auto planted = model_;
  plant(planted.inputs[kInFlexion], 1, -6.5, -6.5);
  pullTo(curveOf(planted));
  for (const auto& [gesture, delta] :
       {std::pair{Gesture::kShift, -6.5}, std::pair{Gesture::kMove, -6.5}, std::pair{Gesture::kWiden, -6.5},
        std::pair{Gesture::kBegin, -15.2941}, std::pair{Gesture::kEnd, -11.3043}}) {
    const CurveCandidate* const one = find(kInFlexion, gesture);
    ASSERT_NE(one, nullptr) << name(gesture);
    EXPECT_NEAR(one->candidate.edits[0].delta, delta, 5.1e-5) << "printed with four digits";
    EXPECT_LT(one->residual_n, 1e-11);
    EXPECT_EQ(one->same_curve, 4U);
  }
  for (std::size_t k = 1; k < 5; ++k) {
    EXPECT_GE(found_.candidates[k].candidate.elsewhere.k_box, found_.candidates[k - 1].candidate.elsewhere.k_box)
        << "the one that moves least elsewhere first";
  }
}

TEST_F(PullCurveTest, TwoEditsOfARuleTie) {
  auto planted = model_;
  planted.experts[0].rules[2].then = "medium";
  pullTo(curveOf(planted));
  ASSERT_NE(rule(3, Gesture::kWord, "medium"), nullptr);
  EXPECT_LT(rule(3, Gesture::kWord, "medium")->residual_n, 1e-12);
  ASSERT_NE(rule(3, Gesture::kOff), nullptr);
  EXPECT_LT(rule(3, Gesture::kOff)->residual_n, 1e-12);
  std::vector<double> residuals;
  for (const CurveCandidate& one : found_.candidates) residuals.push_back(one.residual_n);
  std::sort(residuals.begin(), residuals.end());
  EXPECT_NEAR(residuals[2], .00886, 5.1e-6) << "the third, printed with five digits";
}

TEST_F(PullCurveTest, IntoABand) {
  ReferenceCurve band = emptyCurve();
  for (int depth_mm = 125; depth_mm <= 185; ++depth_mm) {
    addPoint(band, depth_mm, .5, std::numeric_limits<double>::infinity());
  }
  pullTo(band);
  EXPECT_EQ(find(kInDepth, Gesture::kShift) != nullptr && find(kInDepth, Gesture::kShift)->candidate.exact, false)
      << "no gesture in depth is enough";
  // The other program searched on a grid of thousandths, and needs one step more than the smallest delta.
  const CurveCandidate* const shift = find(kInForce, Gesture::kShift);
  ASSERT_NE(shift, nullptr);
  EXPECT_LE(shift->candidate.edits[0].delta, .058);
  EXPECT_GT(shift->candidate.edits[0].delta, .057);
  EXPECT_NEAR(shift->candidate.elsewhere.k, .3617, 3e-3) << "the same step of the grid";
  ASSERT_NE(find(kInForce, Gesture::kMove), nullptr);
  const auto large = std::find_if(found_.candidates.begin(), found_.candidates.end(), [](const CurveCandidate& one) {
    const PullEdit& edit = one.candidate.edits[0];
    return edit.gesture == Gesture::kMove && edit.list.variable == kInForce && edit.place == 3;
  });
  ASSERT_NE(large, found_.candidates.end());
  EXPECT_NEAR(large->candidate.edits[0].delta, .062, 1e-3) << "a step of the grid";
  EXPECT_NEAR(large->candidate.elsewhere.k, .2950, 3e-3);
  ASSERT_NE(rule(28, Gesture::kWord, "very_large"), nullptr);
  EXPECT_EQ(rule(28, Gesture::kWord, "very_large")->residual_n, 0);
  EXPECT_NEAR(rule(28, Gesture::kWord, "very_large")->candidate.elsewhere.k, .3406, 5.1e-5);
  ASSERT_NE(rule(3, Gesture::kWord, "medium"), nullptr);
  EXPECT_NEAR(rule(3, Gesture::kWord, "medium")->candidate.elsewhere.k, .3881, 5.1e-5);
}

// Random single gestures are found again from the curve alone, on the mean too.
TEST_F(PullCurveTest, APlantedGestureOfTheMeanIsFound) {
  model_ = support::inventedExperts();
  auto planted = model_;
  plant(planted.inputs[kInDepth], 1, 3, -5);
  plant(planted.inputs[kInDepth], 1, 0, 5);
  pullTo(curveOf(planted));
  const CurveCandidate* const one = find(kInDepth, Gesture::kBegin);
  ASSERT_NE(one, nullptr);
  EXPECT_NEAR(one->candidate.edits[0].delta, 3, 1e-9);
  EXPECT_LT(one->residual_n, 1e-12);
}

// Thirteen random gestures, each with a random delta, from their curves at every 12 mm.
TEST_F(PullCurveTest, RandomGesturesAreFoundAgain) {
  base::Random random(13);
  int planted = 0;
  while (planted < 13) {
    const auto gestures = gesturesOfList(model_, {static_cast<std::size_t>(random.below(5)), {}});
    const SearchedGesture& one = gestures[static_cast<std::size_t>(random.below(static_cast<int>(gestures.size())))];
    PullEdit edit = one.edit;
    edit.delta = random.uniform(.2, .8) * (random.uniform() < .5 ? one.range.low : one.range.high);
    const ReferenceCurve curve = curveOf(applied(model_, edit), 12);
    const ReferenceFit fit(*fuzzy::compile(model_), curve, noticeable);
    if (fit.of(*fuzzy::compile(model_))->rms_n < 1e-3) continue;  // the curve does not show it
    ++planted;
    pullTo(curve, 16);
    const auto found = std::find_if(found_.candidates.begin(), found_.candidates.end(), [&](const CurveCandidate& c) {
      PullEdit same = c.candidate.edits[0];
      same.delta = edit.delta;
      return c.candidate.edits.size() == 1 && same == edit;
    });
    ASSERT_NE(found, found_.candidates.end()) << name(edit.gesture) << " by " << edit.delta;
    EXPECT_LT(found->residual_n, 1e-9) << name(edit.gesture) << " by " << edit.delta << ": as good as planted";
  }
}

TEST_F(PullCurveTest, SeveralStepsWhereOneIsNotEnough) {
  auto planted = model_;
  planted.experts[0].rules[2].enabled = false;
  plant(planted.inputs[kInFlexion], 1, -10, -10);
  const ReferenceCurve curve = curveOf(planted);
  pullTo(curve);
  const CurveCandidate& best = found_.candidates[0];
  EXPECT_TRUE(found_.close);
  EXPECT_GE(best.candidate.edits.size(), 2U);
  EXPECT_LE(best.candidate.edits.size(), 3U);
  EXPECT_LT(best.residual_n, .9 * found_.candidates[1].residual_n);
  // What is left, by the model itself.
  const auto after = fuzzy::compile(applied(model_, best.candidate.edits));
  double sum = 0;
  for (std::size_t k = 0; k < curve.low_n.size(); ++k) {
    const double point[] = {1, 60, curve.columns[kInDepth][k], 50};
    sum += std::pow(after->evaluate(point).force_n - curve.low_n[k], 2);
  }
  EXPECT_NEAR(best.residual_n, std::sqrt(sum / static_cast<double>(curve.low_n.size())), 1e-12)
      << "rounding of 301 forces";
}

TEST_F(PullCurveTest, NothingToDoAndNothingToCompare) {
  pullTo(curveOf(model_));
  EXPECT_TRUE(found_.close);
  EXPECT_TRUE(found_.candidates.empty());
  const ReferenceCurve curve = curveOf(model_);
  model_.experts[0].rules = {{{{"speed", "fast"}}, "large"}};
  const auto found = pullToCurve(model_, point_, curve, noticeable);
  ASSERT_FALSE(found.has_value());
  EXPECT_NE(found.error().message().find("a reference without a point at which a rule fires"), std::string::npos);
}

}  // namespace
}  // namespace tactus::analysis
