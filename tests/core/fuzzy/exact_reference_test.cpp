// Every evaluation against exact rational arithmetic, on generated models.
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "core/base/random.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/validate.h"

#include "tests/reference/exact_model.h"
#include "tests/support/ngt_model.h"
#include "tests/support/random_model.h"

namespace tactus::fuzzy {
namespace {

/// The promise of the evaluator: 1e-12 of the output's range, and 2 ulp of the force for the last rounding.
double bound(const ForceModel& model, double force) {
  const double ulp = std::nextafter(std::abs(force), std::numeric_limits<double>::infinity()) - std::abs(force);
  return 1e-12 * (model.output.max - model.output.min) + 2 * ulp;
}

double errorOf(double computed, const mpq_class& exact) {
  const mpq_class difference = mpq_class(computed) - exact;
  return std::abs(difference.get_d());
}

void expectExact(const ForceModel& model, const CompiledModel& compiled, const std::vector<double>& point) {
  const auto exact = reference::exactForce(model, point);
  const auto force = compiled.evaluate(point);
  ASSERT_EQ(force.fired, exact.has_value());
  if (exact) {
    ASSERT_LE(errorOf(force.force_n, *exact), bound(model, force.force_n));
  } else {
    ASSERT_EQ(force.force_n, model.default_force_n);
  }
  for (std::size_t e = 0; e < model.experts.size(); ++e) {
    const auto exact_one = reference::exactExpertForce(model, e, point);
    const auto one = compiled.evaluateExpert(e, point);
    ASSERT_EQ(one.fired, exact_one.has_value());
    if (exact_one) {
      ASSERT_LE(errorOf(one.force_n, *exact_one), bound(model, one.force_n));
    }
  }
}

void compareRandomModels(std::uint64_t seed, int models, int points, bool adversarial) {
  base::Random random(seed);
  for (int m = 0; m < models; ++m) {
    const ForceModel model = support::randomModel(random, {.gaussians = false, .adversarial = adversarial});
    const auto compiled = compile(model);
    ASSERT_TRUE(compiled.has_value()) << compiled.error().message();
    for (int p = 0; p < points; ++p) {
      SCOPED_TRACE("model " + std::to_string(m) + ", point " + std::to_string(p));
      expectExact(model, *compiled, support::randomPoint(random, model));
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}

TEST(ExactReference, OrdinaryRandomModels) { compareRandomModels(1, 1500, 4, false); }

TEST(ExactReference, AdversarialRandomModels) { compareRandomModels(2, 2500, 4, true); }

TEST(ExactReference, NgtModelToOneUnitInTheFifteenthDigit) {
  for (const auto implication : {Implication::kClip, Implication::kScale}) {
    ForceModel model = support::s4AsPrinted();
    model.implication = implication;
    const auto compiled = compile(model);
    ASSERT_TRUE(compiled.has_value());
    base::Random random(3);
    for (int i = 0; i < 1000; ++i) {
      const std::vector<double> point = {random.uniform(), random.uniform(0, 90), random.uniform(0, 600),
                                         random.uniform(0, 400)};
      const auto exact = reference::exactForce(model, point);
      const auto force = compiled->evaluate(point);
      ASSERT_EQ(force.fired, exact.has_value());
      // Forces are below 1.1 N, where one ulp is 2.2e-16.
      if (exact) {
        ASSERT_LE(errorOf(force.force_n, *exact), 1e-15);
      }
    }
  }
}

}  // namespace
}  // namespace tactus::fuzzy
