#include "experiments/seeded_order.h"

#include <gtest/gtest.h>
#include <map>
#include <set>
#include <string>

namespace tactus::experiments {
namespace {

TEST(SeededOrder, BlocksAndSeedsHaveSeedsOfTheirOwn) {
  std::set<std::uint64_t> seeds;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    for (const char* block : {"speed/levels", "force/descending", "force/random"}) seeds.insert(blockSeed(seed, block));
  }
  EXPECT_EQ(seeds.size(), 3000U);
  EXPECT_EQ(blockSeed(7, "force/random"), blockSeed(7, "force/random"));
}

TEST(SeededOrder, EachOrderIsAboutEquallyLikely) {
  std::map<std::string, int> counts;
  constexpr int kDraws = 6000;
  for (std::uint64_t seed = 0; seed < kDraws; ++seed) {
    base::Random random(blockSeed(seed, "test"));
    const auto order = shuffled(std::vector<char>{'a', 'b', 'c'}, random);
    ++counts[std::string(order.begin(), order.end())];
  }
  ASSERT_EQ(counts.size(), 6U);
  // 1000 expected, standard deviation 29: five of them.
  for (const auto& [order, count] : counts) EXPECT_NEAR(count, 1000, 145) << order;
}

}  // namespace
}  // namespace tactus::experiments
