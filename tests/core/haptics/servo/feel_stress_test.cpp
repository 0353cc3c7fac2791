// Hundreds of hands under the servo, stressed in every way at once; a longer run of the same is in the preset soak.
#include <gtest/gtest.h>

#include "tests/stress/feel_run.h"

namespace tactus::stress {
namespace {

class FeelStress : public testing::TestWithParam<std::uint64_t> {};

TEST_P(FeelStress, NothingHappensThatMustNot) {
  constexpr std::uint64_t kRuns = 150;
  int limited = 0;
  for (std::uint64_t i = 0; i < kRuns; ++i) {
    const std::uint64_t number = GetParam() * kRuns + i;
    const FeelRun run = feelRun(number);
    ASSERT_FALSE(run.violation) << "run " << number << ": " << *run.violation << "; " << run.what;
    if (run.most_transitions > 0) {
      ++limited;
      EXPECT_LE(run.transitions, run.most_transitions) << "run " << number << ": " << run.what;
    }
    if (run.most_ripple_n > 0) {
      EXPECT_LE(run.ripple_n, run.most_ripple_n) << "run " << number << ": " << run.what;
    }
  }
  EXPECT_GT(limited, 0);
}

// In parts, so that they run side by side.
INSTANTIATE_TEST_SUITE_P(Part, FeelStress, testing::Range<std::uint64_t>(0, 8));

}  // namespace
}  // namespace tactus::stress
