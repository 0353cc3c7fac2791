// A short run of what tests/stress/fcm_soak.cpp does a million times.
#include <gtest/gtest.h>

#include "tests/stress/fcm_agreement.h"

namespace tactus::stress {
namespace {

TEST(FcmProperties, HoldForRandomInputs) {
  for (std::uint64_t number = 0; number < 500; ++number) {
    base::Random random(0xF1CA000U + number);
    const FcmInput input = randomFcmInput(random);
    const auto found = checkClustering(input, random, 1, number % 16 == 0);
    ASSERT_FALSE(found.disagreement) << "input " << number << ": " << *found.disagreement << '\n' << input.describe();
    EXPECT_FALSE(found.unfinished) << input.describe();
  }
}

}  // namespace
}  // namespace tactus::stress
