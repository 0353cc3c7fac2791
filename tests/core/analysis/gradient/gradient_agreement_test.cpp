// The closed form against the general sweep, and a gradient that is used again against a new one.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <string>

#include "core/analysis/gradient/gradient.h"
#include "core/base/random.h"

#include "tests/support/ngt_model.h"
#include "tests/support/ordered_model.h"
#include "tests/support/random_model.h"

namespace tactus::analysis {
namespace {

using fuzzy::ForceModel;

/// By slot: universe of the force over that of the parameter, the unit in which an error means something.
std::vector<double> unitsOf(const ForceModel& model, const GradientModel& gradients) {
  const double range_n = model.output.max - model.output.min;
  std::vector<double> units(gradients.slotCount(), range_n);
  for (std::size_t v = 0; v <= model.inputs.size(); ++v) {
    const auto& variable = v < model.inputs.size() ? model.inputs[v] : model.output;
    const double unit = range_n / (variable.max - variable.min);
    if (v < model.inputs.size()) units[gradients.inputSlot(v)] = unit;
    for (std::size_t e = 0; e < model.experts.size(); ++e) {
      const auto& terms = termsFor(model.experts[e], variable);
      for (std::size_t t = 0; t < terms.size(); ++t) {
        for (std::size_t p = 0; p < terms[t].points.size(); ++p) units[gradients.pointSlot(e, v, t, p)] = unit;
      }
    }
  }
  return units;
}

struct Disagreement {
  long compared = 0;
  long differ = 0;
};

/// The tolerance is 1e-11: each is within 1e-12 of what cancels in the derivative, which is some times its unit.
void compareBothWays(const ForceModel& model, const std::vector<double>& point, const GradientModel& closed,
                     const GradientModel& general, Disagreement& tally) {
  const Gradient one = closed.evaluate(point);
  const Gradient two = general.evaluate(point);
  ASSERT_EQ(one.fired, two.fired);
  ASSERT_NEAR(one.force_n, two.force_n, 1e-13 * (model.output.max - model.output.min) + 4e-16 * std::abs(two.force_n));
  const auto units = unitsOf(model, closed);
  for (std::size_t slot = 0; slot < units.size(); ++slot) {
    const double tolerance = 1e-11 * std::max({std::abs(one[slot]), std::abs(two[slot]), units[slot]});
    tally.compared += one[slot] != 0 || two[slot] != 0 ? 1 : 0;
    tally.differ += std::abs(one[slot] - two[slot]) <= tolerance ? 0 : 1;
  }
}

TEST(GradientAgreement, ClosedFormAndGeneralSweepOnTheNgtModel) {
  base::Random random(31);
  Disagreement tally;
  for (const auto implication : {fuzzy::Implication::kClip, fuzzy::Implication::kScale}) {
    ForceModel model = support::s4FiveRegions();
    model.implication = implication;
    const auto closed = GradientModel::of(model);
    const auto general = GradientModel::of(model, GradientMethod::kGeneral);
    ASSERT_TRUE(closed->hasClosedForm(0));
    ASSERT_FALSE(general->hasClosedForm(0));
    for (int i = 0; i < 500; ++i) {
      compareBothWays(model, {random.uniform(), random.uniform(0, 90), random.uniform(0, 600), random.uniform(0, 400)},
                      *closed, *general, tally);
    }
  }
  EXPECT_EQ(tally.differ, 0);
  EXPECT_GT(tally.compared, 10'000);
}

// Rules that tie but for rounding may be told apart differently; more than a few such would be an error.
TEST(GradientAgreement, ClosedFormAndGeneralSweepOnOrderedModels) {
  base::Random random(32);
  Disagreement tally;
  int closed_forms = 0;
  for (int m = 0; m < 2000; ++m) {
    SCOPED_TRACE("model " + std::to_string(m));
    const ForceModel model = support::randomOrderedModel(random);
    const auto closed = GradientModel::of(model);
    const auto general = GradientModel::of(model, GradientMethod::kGeneral);
    ASSERT_TRUE(closed.has_value()) << closed.error().message();
    for (std::size_t e = 0; e < model.experts.size(); ++e) closed_forms += closed->hasClosedForm(e) ? 1 : 0;
    for (int p = 0; p < 3; ++p)
      compareBothWays(model, support::randomOrderedPoint(random, model), *closed, *general, tally);
  }
  EXPECT_GT(closed_forms, 2000);
  EXPECT_GT(tally.compared, 100'000);
  EXPECT_LE(tally.differ, tally.compared / 5000);
}

// What one point leaves behind must not show at the next, whatever happens in between.
TEST(GradientAgreement, AGradientUsedAgainIsAsGoodAsANewOne) {
  base::Random random(33);
  for (int m = 0; m < 200; ++m) {
    const bool ordered = m % 2 == 0;
    const ForceModel model = ordered ? support::randomOrderedModel(random) : support::randomModel(random);
    const auto gradients = GradientModel::of(model);
    ASSERT_TRUE(gradients.has_value());
    Gradient again = gradients->makeGradient();
    for (int p = 0; p < 20; ++p) {
      auto point = ordered ? support::randomOrderedPoint(random, model) : support::randomPoint(random, model);
      if (p % 7 == 3) point[0] = std::numeric_limits<double>::quiet_NaN();
      gradients->evaluate(point, again);
      const Gradient fresh = gradients->evaluate(point);
      ASSERT_EQ(again.fired, fresh.fired);
      for (std::size_t slot = 0; slot < gradients->slotCount(); ++slot) {
        ASSERT_TRUE(again[slot] == fresh[slot] || (std::isnan(again[slot]) && std::isnan(fresh[slot])));
      }
    }
  }
}

}  // namespace
}  // namespace tactus::analysis
