#include "core/haptics/servo/loop_statistics.h"

#include <gtest/gtest.h>
#include <limits>

namespace tactus::haptics {
namespace {

TEST(TimeHistogram, HasTwoBinsToAnOctave) {
  // By hand: 256, 384, 512, 768, 1024, ... ns.
  EXPECT_EQ(TimeHistogram::binOf(-5), 0U);
  EXPECT_EQ(TimeHistogram::binOf(0), 0U);
  EXPECT_EQ(TimeHistogram::binOf(255), 0U);
  EXPECT_EQ(TimeHistogram::binOf(256), 1U);
  EXPECT_EQ(TimeHistogram::binOf(383), 1U);
  EXPECT_EQ(TimeHistogram::binOf(384), 2U);
  EXPECT_EQ(TimeHistogram::binOf(511), 2U);
  EXPECT_EQ(TimeHistogram::binOf(512), 3U);
  EXPECT_EQ(TimeHistogram::binOf(1'000'000), 24U);      // 2^19 = 524,288 and 1.5 times that is 786,432
  EXPECT_EQ(TimeHistogram::binOf(4'294'967'295), 48U);  // 2^32 - 1
  EXPECT_EQ(TimeHistogram::binOf(4'294'967'296), 49U);
  EXPECT_EQ(TimeHistogram::binOf(std::numeric_limits<std::int64_t>::max()), 49U);
}

TEST(TimeHistogram, EachBinBeginsWhereTheOneBeforeEnds) {
  EXPECT_EQ(TimeHistogram::endNs(0), 256);
  EXPECT_EQ(TimeHistogram::endNs(1), 384);
  EXPECT_EQ(TimeHistogram::endNs(24), 1'048'576);
  for (std::size_t bin = 0; bin + 1 < TimeHistogram::kBins; ++bin) {
    EXPECT_EQ(TimeHistogram::binOf(TimeHistogram::endNs(bin) - 1), bin);
    EXPECT_EQ(TimeHistogram::binOf(TimeHistogram::endNs(bin)), bin + 1);
  }
}

TEST(TimeHistogram, AQuantileIsTheEndOfItsBin) {
  TimeHistogram histogram;
  EXPECT_EQ(histogram.quantileNs(0.5), 0);
  histogram.counts[1] = 98;  // below 384
  histogram.counts[3] = 1;   // below 768
  histogram.counts[5] = 1;   // below 1536
  histogram.largest_ns = 1100;
  EXPECT_EQ(histogram.total(), 100U);
  EXPECT_EQ(histogram.quantileNs(0.5), 384);
  EXPECT_EQ(histogram.quantileNs(0.98), 384);
  EXPECT_EQ(histogram.quantileNs(0.99), 768);
  EXPECT_EQ(histogram.quantileNs(1), 1100) << "no more than the largest time";
}

TEST(LoopMeter, CountsByHand) {
  LoopMeter meter;
  // Beginnings of five ticks, microseconds: gaps of 1000, 1010, 3990 and 40.
  constexpr std::int64_t kPeriod = 1'000'000;
  constexpr std::int64_t kBegin[] = {10'000, 1'010'000, 2'020'000, 6'010'000, 6'050'000};
  constexpr std::int64_t kLate[] = {0, 0, 10'000, 3'000'000, 2'040'000};
  constexpr std::int64_t kDuration[] = {300, 300, 400, 600, 300};
  for (int i = 0; i < 5; ++i) {
    meter.begin(kBegin[i]);
    meter.readAge(200'000 + i);
    if (i > 0) meter.writeAge(1'000'000);
    meter.end(kLate[i], kDuration[i], kPeriod);
  }
  const LoopStatistics seen = meter.snapshot();
  EXPECT_EQ(seen.ticks, 5U);
  EXPECT_EQ(seen.missed, 2U);
  EXPECT_EQ(seen.longest_gap_ns, 3'990'000);
  EXPECT_EQ(seen.lateness.counts[0], 2U);
  EXPECT_EQ(seen.lateness.counts[TimeHistogram::binOf(10'000)], 1U);
  EXPECT_EQ(seen.lateness.total(), 5U);
  EXPECT_EQ(seen.lateness.largest_ns, 3'000'000);
  EXPECT_EQ(seen.tick_duration.counts[1], 3U);
  EXPECT_EQ(seen.tick_duration.counts[2], 1U);
  EXPECT_EQ(seen.tick_duration.counts[3], 1U);
  EXPECT_EQ(seen.read_age.total(), 5U);
  EXPECT_EQ(seen.read_age.largest_ns, 200'004);
  EXPECT_EQ(seen.write_age.total(), 4U);
}

TEST(LoopMeter, APeriodLateIsNotYetMissed) {
  LoopMeter meter;
  meter.end(1'000'000, 0, 1'000'000);
  EXPECT_EQ(meter.snapshot().missed, 0U);
  meter.end(1'000'001, 0, 1'000'000);
  EXPECT_EQ(meter.snapshot().missed, 1U);
}

TEST(LoopMeter, APauseIsNoGap) {
  LoopMeter meter;
  meter.begin(0);
  meter.begin(1'000'000);
  meter.pause();
  meter.begin(900'000'000);
  meter.begin(901'500'000);
  EXPECT_EQ(meter.snapshot().longest_gap_ns, 1'500'000);
}

TEST(LoopMeter, RemembersTheLastAndTheLongestWaitOfOrders) {
  LoopMeter meter;
  meter.ordersTaken(1);
  meter.ordersTaken(2);
  meter.ordersTaken(1);
  const LoopStatistics seen = meter.snapshot();
  EXPECT_EQ(seen.orders_taken, 3U);
  EXPECT_EQ(seen.last_wait_ticks, 1U);
  EXPECT_EQ(seen.longest_wait_ticks, 2U);
}

}  // namespace
}  // namespace tactus::haptics
