// Evaluation must not allocate: the servo calls it a thousand times a second.
#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/fuzzy/compiled_model.h"

#include "tests/support/allocation_counter.h"
#include "tests/support/random_model.h"

namespace tactus::fuzzy {
namespace {

TEST(Allocation, EvaluationNeverAllocates) {
  base::Random random(5);
  for (int m = 0; m < 200; ++m) {
    const ForceModel model = support::randomModel(random, {.gaussians = m % 2 == 0, .adversarial = true});
    const auto compiled = compile(model);
    ASSERT_TRUE(compiled.has_value());
    const auto point = support::randomPoint(random, model);
    const long before = support::allocations();
    (void)compiled->evaluate(point);
    for (std::size_t e = 0; e < compiled->expertCount(); ++e) (void)compiled->evaluateExpert(e, point);
    ASSERT_EQ(support::allocations(), before);
  }
  EXPECT_GT(support::allocations(), 0) << "the counter counts nothing";
}

}  // namespace
}  // namespace tactus::fuzzy
