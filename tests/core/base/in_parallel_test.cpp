#include "core/base/in_parallel.h"

#include <gtest/gtest.h>

namespace tactus::base {
namespace {

TEST(InParallel, EachNumberIsDoneOnceOnAnyNumberOfThreads) {
  for (const unsigned threads : {1U, 2U, 7U}) {
    for (const std::size_t count : {0U, 1U, 3U, 100U}) {
      std::vector<std::atomic<int>> done(count);
      std::vector<double> shares;
      EXPECT_TRUE(inParallel(
          count, threads, [&](std::size_t one) { ++done[one]; },
          [&](double share) {
            shares.push_back(share);
            return true;
          }));
      for (const auto& times : done) EXPECT_EQ(times, 1) << threads << " threads, " << count;
      EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
      EXPECT_EQ(shares.empty() ? 1 : shares.back(), 1);
    }
  }
}

TEST(InParallel, EndsEarlyWhereTheCallerSaysSo) {
  for (const unsigned threads : {1U, 3U}) {
    std::atomic<int> done{0};
    const auto slow = [&](std::size_t) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      ++done;
    };
    EXPECT_FALSE(inParallel(10'000, threads, slow, [&](double share) { return share < 0.001; }));
    EXPECT_LT(done, 10'000);
  }
}

}  // namespace
}  // namespace tactus::base
