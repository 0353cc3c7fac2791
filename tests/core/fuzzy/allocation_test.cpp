// Evaluation must not allocate: the servo calls it a thousand times a second.
#include <cstdlib>
#include <gtest/gtest.h>
#include <new>

#include "core/base/random.h"
#include "core/fuzzy/compiled_model.h"

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

namespace tactus::fuzzy {
namespace {

TEST(Allocation, EvaluationNeverAllocates) {
  base::Random random(5);
  for (int m = 0; m < 200; ++m) {
    const ForceModel model = support::randomModel(random, {.gaussians = m % 2 == 0, .adversarial = true});
    const auto compiled = compile(model);
    ASSERT_TRUE(compiled.has_value());
    const auto point = support::randomPoint(random, model);
    const long before = allocations;
    (void)compiled->evaluate(point);
    for (std::size_t e = 0; e < compiled->expertCount(); ++e) (void)compiled->evaluateExpert(e, point);
    ASSERT_EQ(allocations, before);
  }
  EXPECT_GT(allocations, 0) << "the counter counts nothing";
}

}  // namespace
}  // namespace tactus::fuzzy
