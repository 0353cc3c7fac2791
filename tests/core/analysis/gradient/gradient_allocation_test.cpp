// An editor may ask for gradients while the servo runs: they must not allocate.
#include <gtest/gtest.h>

#include "core/analysis/gradient/gradient.h"
#include "core/base/random.h"

#include "tests/support/random_model.h"
#include "tests/support/real_time_trap.h"

namespace tactus::analysis {
namespace {

TEST(GradientAllocation, EvaluationNeverAllocates) {
  base::Random random(15);
  for (int m = 0; m < 100; ++m) {
    const fuzzy::ForceModel model = support::randomModel(random, {.gaussians = m % 2 == 0, .adversarial = true});
    const auto gradients = GradientModel::of(model);
    ASSERT_TRUE(gradients.has_value());
    Gradient gradient = gradients->makeGradient();
    const auto point = support::randomPoint(random, model);
    const long before = support::allocations();
    gradients->evaluate(point, gradient);
    ASSERT_EQ(support::allocations(), before);
  }
  EXPECT_GT(support::allocations(), 0) << "the counter counts nothing";
}

}  // namespace
}  // namespace tactus::analysis
