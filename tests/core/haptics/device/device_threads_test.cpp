#include "core/haptics/device/device_threads.h"

#include <array>
#include <gtest/gtest.h>
#include <thread>

namespace tactus::haptics {
namespace {

TEST(NewestValue, TheNewestOneCountsAndStays) {
  NewestValue<int> value;
  EXPECT_FALSE(value.fresh());
  EXPECT_EQ(value.take(), 0);
  value.put(1);
  value.put(2);
  EXPECT_TRUE(value.fresh());
  EXPECT_EQ(value.take(), 2);
  EXPECT_FALSE(value.fresh());
  EXPECT_EQ(value.take(), 2);
  value.put(3);
  EXPECT_EQ(value.take(), 3);
}

/// Larger than a cache line, and every word follows from the first: a torn copy shows.
struct Large {
  std::array<std::uint64_t, 32> words{};
};

TEST(NewestValue, IsNeverTornAndNeverGoesBack) {
  constexpr std::uint64_t kLast = 100'000;
  NewestValue<Large> value;
  std::thread writer([&] {
    for (std::uint64_t number = 1; number <= kLast; ++number) {
      Large large;
      for (std::size_t i = 0; i < large.words.size(); ++i) large.words[i] = number * (i + 1);
      value.put(large);
    }
  });
  std::uint64_t before = 0;
  bool whole = true;
  bool forward = true;
  while (before < kLast) {
    const Large& large = value.take();
    for (std::size_t i = 0; i < large.words.size(); ++i) whole = whole && large.words[i] == large.words[0] * (i + 1);
    forward = forward && large.words[0] >= before;
    before = large.words[0];
  }
  writer.join();
  EXPECT_TRUE(whole);
  EXPECT_TRUE(forward);
}

}  // namespace
}  // namespace tactus::haptics
