#include <array>
#include <atomic>
#include <cstdint>
#include <gtest/gtest.h>
#include <thread>
#include <vector>

#include "core/haptics/servo/servo.h"

namespace tactus::haptics {
namespace {

static_assert(sizeof(Sample) > 64, "larger than a cache line, so that tearing would show");
static_assert(SampleRing::kDefaultCapacity >= 8192);

/// A sample whose every number follows from the tick.
Sample sampleOf(std::uint64_t tick) {
  Sample sample;
  sample.tick = tick;
  const auto x = static_cast<double>(tick);
  sample.time_ns = static_cast<std::int64_t>(tick * 3);
  sample.orders = tick * 5;
  sample.position_mm = 7 * x;
  sample.speed_mm_s = 11 * x;
  sample.depth_mm = 13 * x;
  sample.stretch_mm = 17 * x;
  sample.source_force_n = 19 * x;
  sample.force_n = 23 * x;
  sample.stiffness_n_mm = 29 * x;
  sample.buttons = static_cast<std::uint32_t>(tick * 31);
  sample.limited = static_cast<std::uint32_t>(tick * 37);
  return sample;
}

bool isWhole(const Sample& sample) {
  const Sample wanted = sampleOf(sample.tick);
  return sample.time_ns == wanted.time_ns && sample.orders == wanted.orders &&
         sample.position_mm == wanted.position_mm && sample.speed_mm_s == wanted.speed_mm_s &&
         sample.depth_mm == wanted.depth_mm && sample.stretch_mm == wanted.stretch_mm &&
         sample.source_force_n == wanted.source_force_n && sample.force_n == wanted.force_n &&
         sample.stiffness_n_mm == wanted.stiffness_n_mm && sample.buttons == wanted.buttons &&
         sample.limited == wanted.limited;
}

TEST(SampleRing, GivesSamplesInTheirOrder) {
  SampleRing ring(4);
  std::array<Sample, 8> room;
  EXPECT_TRUE(ring.drain(room).empty());
  std::uint64_t next = 1;
  for (int round = 0; round < 5; ++round) {  // around the end of the memory
    for (std::uint64_t i = 0; i < 3; ++i) ring.push(sampleOf(next + i));
    const auto drained = ring.drain(room);
    ASSERT_EQ(drained.size(), 3U);
    for (const Sample& sample : drained) EXPECT_EQ(sample.tick, next++);
  }
  EXPECT_EQ(ring.dropped(), 0U);
}

TEST(SampleRing, FillsNoMoreThanTheRoom) {
  SampleRing ring(8);
  for (std::uint64_t tick = 1; tick <= 5; ++tick) ring.push(sampleOf(tick));
  std::array<Sample, 2> room;
  EXPECT_EQ(ring.drain(room).back().tick, 2U);
  EXPECT_EQ(ring.drain(room).back().tick, 4U);
  EXPECT_EQ(ring.drain(room).size(), 1U);
  EXPECT_EQ(room[0].tick, 5U);
}

TEST(SampleRing, KeepsTheOldAndCountsTheNewWhenItIsFull) {
  SampleRing ring(4);
  for (std::uint64_t tick = 1; tick <= 10; ++tick) ring.push(sampleOf(tick));
  EXPECT_EQ(ring.dropped(), 6U);
  std::array<Sample, 8> room;
  const auto drained = ring.drain(room);
  ASSERT_EQ(drained.size(), 4U);
  EXPECT_EQ(drained.front().tick, 1U);
  EXPECT_EQ(drained.back().tick, 4U);
  ring.push(sampleOf(11));
  EXPECT_EQ(ring.drain(room).front().tick, 11U);
  EXPECT_EQ(ring.dropped(), 6U);
}

/// What a reader sees of `pushes` samples that another thread pushes meanwhile.
void pushAndDrain(std::size_t capacity, std::uint64_t pushes) {
  SampleRing ring(capacity);
  std::atomic<bool> reading{false};
  std::thread writer([&] {
    while (!reading.load()) std::this_thread::yield();
    for (std::uint64_t tick = 1; tick <= pushes; ++tick) {
      ring.push(sampleOf(tick));
      if (tick % 256 == 0) std::this_thread::yield();
    }
  });
  std::vector<Sample> room(100);
  reading.store(true);
  std::uint64_t seen = 0, torn = 0, disorder = 0, last = 0;
  while (seen + ring.dropped() < pushes) {
    for (const Sample& sample : ring.drain(room)) {
      ++seen;
      if (!isWhole(sample)) ++torn;
      if (sample.tick <= last) ++disorder;
      last = sample.tick;
    }
  }
  writer.join();
  EXPECT_EQ(torn, 0U);
  EXPECT_EQ(disorder, 0U);
  EXPECT_EQ(seen + ring.dropped(), pushes) << "every sample is drained or counted";
  EXPECT_TRUE(ring.drain(room).empty());
}

TEST(SampleRing, BetweenTwoThreadsEverySampleIsWhole) { pushAndDrain(SampleRing::kDefaultCapacity, 200'000); }

TEST(SampleRing, BetweenTwoThreadsASmallRingDropsButNeverMixes) { pushAndDrain(16, 200'000); }

}  // namespace
}  // namespace tactus::haptics
