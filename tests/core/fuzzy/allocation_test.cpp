// Evaluation must not allocate: the servo calls it a thousand times a second.
#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/fuzzy/batch.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/scene.h"

#include "tests/support/random_model.h"
#include "tests/support/real_time_trap.h"

namespace tactus::fuzzy {
namespace {

constexpr std::size_t kAllocationPoints = 37;  ///< not a whole number of batches

TEST(Allocation, EvaluationNeverAllocates) {
  base::Random random(5);
  for (int m = 0; m < 200; ++m) {
    const ForceModel model = support::randomModel(random, {.gaussians = m % 2 == 0, .adversarial = true});
    const auto compiled = compile(model);
    ASSERT_TRUE(compiled.has_value());
    const auto point = support::randomPoint(random, model);
    std::vector<std::optional<double>> fixed(point.size());
    fixed[0] = point[0];
    const auto scene = Scene::specialize(*compiled, fixed);
    std::vector<double> force_n(kAllocationPoints);
    std::vector<std::uint8_t> fired(kAllocationPoints);
    std::vector<std::vector<double>> columns;
    for (const double x : point) columns.emplace_back(kAllocationPoints, x);
    const std::vector<std::span<const double>> all(columns.begin(), columns.end());
    const auto free = std::span(all).subspan(1);
    const long before = support::allocations();
    (void)compiled->evaluate(point);
    for (std::size_t e = 0; e < compiled->expertCount(); ++e) (void)compiled->evaluateExpert(e, point);
    evaluateBatch(*compiled, all, {force_n, fired});
    (void)scene->evaluate(std::span(point).subspan(1));
    scene->evaluateBatch(free, {force_n, fired});
    ASSERT_EQ(support::allocations(), before);
  }
  EXPECT_GT(support::allocations(), 0) << "the counter counts nothing";
}

}  // namespace
}  // namespace tactus::fuzzy
