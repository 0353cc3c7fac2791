// An editor may ask for gradients while the servo runs: they must not allocate.
#include <cstdlib>
#include <gtest/gtest.h>
#include <new>

#include "core/analysis/gradient.h"
#include "core/base/random.h"

#include "tests/support/random_model.h"

namespace {
thread_local long allocations = 0;
}

void* operator new(std::size_t size) {
  ++allocations;
  if (void* const memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

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
    const long before = allocations;
    gradients->evaluate(point, gradient);
    ASSERT_EQ(allocations, before);
  }
  EXPECT_GT(allocations, 0) << "the counter counts nothing";
}

}  // namespace
}  // namespace tactus::analysis
