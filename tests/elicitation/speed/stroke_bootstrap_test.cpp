#include "elicitation/speed/stroke_bootstrap.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/base/statistics.h"

#include "tests/elicitation/golden_speeds.h"

namespace tactus::elicitation {
namespace {

std::vector<double> centresOf(const std::string& file) {
  return goldenSubject(file).at("centres").get<std::vector<double>>();
}

StrokeBootstrap bootstrapOf(const std::vector<study::SpeedSample>& samples, const std::vector<double>& centres,
                            std::uint64_t seed = 1, SpeedCentres kind = SpeedCentres::kClusters) {
  SpeedTermSettings settings;
  settings.centres = kind;
  return StrokeBootstrap::of(samples, goldenLevels(), centres, settings, seed).value();
}

/// The middle 95 % of the draws (Efron 1979): what the references have, and too narrow for few strokes.
SpeedIntervals percentiles(const StrokeBootstrap& bootstrap) {
  const auto of = [](const auto& draws, auto value) {
    std::vector<double> values;
    for (const auto& one : draws) values.push_back(value(one));
    return Interval{base::quantile(values, 0.025), base::quantile(values, 0.975)};
  };
  SpeedIntervals out;
  for (std::size_t k = 0; k < 3; ++k) {
    out.centres.push_back(of(bootstrap.centres(), [k](const std::vector<double>& one) { return one[k]; }));
  }
  for (std::size_t k = 0; k < 2; ++k) {
    out.ramps.push_back({of(bootstrap.ramps(), [k](const std::vector<Ramp>& one) { return one[k].p; }),
                         of(bootstrap.ramps(), [k](const std::vector<Ramp>& one) { return one[k].q; })});
  }
  return out;
}

void expectNear(const Interval& found, double low, double high, double share) {
  // Two bootstraps differ by chance: the 2.5 % quantile of a normal distribution from n replicates has a standard
  // error of 2.67 / sqrt(n) standard deviations, or 0.68 / sqrt(n) interval widths.
  EXPECT_NEAR(found.low, low, share * (high - low));
  EXPECT_NEAR(found.high, high, share * (high - low));
}

void expectNear(const Interval& found, const nlohmann::json& wanted, double share) {
  expectNear(found, wanted[0].get<double>(), wanted[1].get<double>(), share);
}

void expectEqual(const SpeedIntervals& a, const SpeedIntervals& b) {
  EXPECT_EQ(a.replicates, b.replicates);
  for (std::size_t k = 0; k < a.centres.size(); ++k) {
    EXPECT_EQ(a.centres[k].low, b.centres[k].low);
    EXPECT_EQ(a.centres[k].high, b.centres[k].high);
  }
  for (std::size_t k = 0; k < a.ramps.size(); ++k) {
    EXPECT_EQ(a.ramps[k].p.low, b.ramps[k].p.low);
    EXPECT_EQ(a.ramps[k].q.high, b.ramps[k].q.high);
  }
}

TEST(StrokeBootstrap, DrawsAreThoseOfResamplingEverySample) {
  // The reference clusters all samples of each replicate. 2000 replicates here and there: 0.022 widths, times four.
  auto bootstrap = bootstrapOf(goldenStrokes("S1_600.csv"), centresOf("S1_600.csv"));
  bootstrap.add(kBootstrapReplicates);
  const auto found = percentiles(bootstrap);
  const auto wanted = goldenSubject("S1_600.csv").at("interval_over_strokes");
  for (std::size_t k = 0; k < 3; ++k) expectNear(found.centres[k], wanted.at("centres")[k], 0.09);
  for (std::size_t k = 0; k < 2; ++k) {
    expectNear(found.ramps[k].p, wanted.at("ramps_0.95")[2 * k], 0.09);
    expectNear(found.ramps[k].q, wanted.at("ramps_0.95")[2 * k + 1], 0.09);
  }
}

TEST(StrokeBootstrap, TwentyFourThousandSamples) {
  auto bootstrap = bootstrapOf(goldenStrokes("S1_24k.csv"), centresOf("S1_24k.csv"));
  bootstrap.add(kBootstrapReplicates);
  const auto found = percentiles(bootstrap);
  // Computed elsewhere for these strokes with an unknown number of replicates; 400 would be 0.037 widths, times four.
  expectNear(found.centres[0], 41.5, 51.4, 0.15);
  expectNear(found.centres[1], 137.5, 162.7, 0.15);
  expectNear(found.centres[2], 264, 361, 0.15);
  const auto wanted = goldenSubject("S1_24k.csv").at("interval_over_strokes");
  for (std::size_t k = 0; k < 3; ++k) expectNear(found.centres[k], wanted.at("centres")[k], 0.15);
}

TEST(StrokeBootstrap, ResamplingSamplesIsTenTimesTooNarrow) {
  auto samples = goldenStrokes("S1_24k.csv");
  const auto centres = centresOf("S1_24k.csv");
  auto strokes = bootstrapOf(samples, centres);
  int stroke = 0;
  for (auto& sample : samples) sample.stroke = ++stroke;
  auto singles = bootstrapOf(samples, centres);
  strokes.add(400);
  singles.add(200);
  const auto wide = percentiles(strokes);
  const auto narrow = percentiles(singles);
  const auto wanted = goldenSubject("S1_24k.csv").at("interval_over_samples").at("centres");
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_GT(wide.centres[k].high - wide.centres[k].low, 10 * (narrow.centres[k].high - narrow.centres[k].low));
    expectNear(narrow.centres[k], wanted[k], 0.25);  // 200 and 400 replicates: 0.059 widths, times four
  }
}

TEST(StrokeBootstrap, EqualStrokesHaveNoInterval) {
  // Each stroke holds all samples of its level, so that every draw is the original; only the bins can move a center.
  auto samples = goldenStrokes("S1_24k.csv");
  for (auto& sample : samples) sample.stroke = 1;
  const std::size_t count = samples.size();
  for (std::size_t i = 0; i < count; ++i) {
    samples.push_back(samples[i]);
    samples.back().stroke = 2;
  }
  const auto centres = centresOf("S1_24k.csv");
  auto bootstrap = bootstrapOf(samples, centres);
  bootstrap.add(5);
  const auto found = bootstrap.intervals();
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(found.centres[k].low, centres[k], 0.001);  // what the header of StrokeResampler promises
    EXPECT_NEAR(found.centres[k].high, centres[k], 0.001);
  }
}

TEST(StrokeBootstrap, LevelMeansByHand) {
  // Two strokes a level, of 0 and 2, 10 and 14, 20 and 20: the mean of a draw is 0, 1 or 2 with chances 1/4, 1/2, 1/4.
  std::vector<study::SpeedSample> samples;
  const double speeds[3][2] = {{0, 2}, {10, 14}, {20, 20}};
  for (std::size_t level = 0; level < 3; ++level) {
    for (int stroke = 0; stroke < 2; ++stroke) {
      for (int i = 0; i < 3; ++i) samples.push_back({"S1", goldenLevels()[level], stroke, 0, 0, speeds[level][stroke]});
    }
  }
  auto bootstrap = bootstrapOf(samples, {1, 12, 20}, 5, SpeedCentres::kLevelMeans);
  bootstrap.add(4000);
  const auto found = bootstrap.intervals(0.5);
  // The draws have a standard deviation of sqrt(1/2), twice that, and 0. Two strokes widen it by sqrt(2), and with one
  // degree of freedom t is tan(pi / 4) = 1 for a half. 4000 draws: 0.8 % of a standard deviation, times five.
  EXPECT_NEAR(found.centres[0].low, 0, 0.04);
  EXPECT_NEAR(found.centres[0].high, 2, 0.04);
  EXPECT_NEAR(found.centres[1].low, 10, 0.08);
  EXPECT_NEAR(found.centres[1].high, 14, 0.08);
  EXPECT_EQ(found.centres[2].low, 20);
  EXPECT_EQ(found.centres[2].high, 20);
  EXPECT_EQ(bootstrap.intervals(0).centres[0].low, 1);
  EXPECT_EQ(bootstrap.intervals(0.95).centres[0].low, 0);  // no speed is below 0
}

TEST(StrokeBootstrap, ALevelWithFewStrokesWidensItsOwnCentre) {
  // Strokes of -5, 0 and 5 mm/s around 100, 200 and 300, nine of each level, but three of the fast one.
  std::vector<study::SpeedSample> samples;
  for (std::size_t level = 0; level < 3; ++level) {
    for (int stroke = 0; stroke < (level == 2 ? 3 : 9); ++stroke) {
      const double speed_mm_s = 100.0 * static_cast<double>(level + 1) + 5 * (stroke % 3 - 1);
      for (int i = 0; i < 5; ++i) samples.push_back({"S1", goldenLevels()[level], stroke, 0, 0, speed_mm_s});
    }
  }
  auto bootstrap = bootstrapOf(samples, {100, 200, 300}, 1, SpeedCentres::kLevelMeans);
  bootstrap.add(4000);
  const auto found = bootstrap.intervals();
  // Student's intervals by hand: t of 8 degrees times sqrt(150 / 8 / 9), t of 2 degrees times sqrt(50 / 2 / 3). 4000
  // draws: 1.1 %, times four.
  for (std::size_t k = 0; k < 3; ++k) {
    const double half = k < 2 ? 2.3060 * std::sqrt(150.0 / 72) : 4.3027 * std::sqrt(25.0 / 3);
    EXPECT_NEAR(found.centres[k].high - found.centres[k].low, 2 * half, 0.045 * 2 * half) << k;
  }
}

/// One sample for each of the two strokes of each level.
std::vector<study::SpeedSample> singleSamples(const double (&speeds_mm_s)[3][2]) {
  std::vector<study::SpeedSample> samples;
  for (std::size_t level = 0; level < 3; ++level) {
    for (int stroke = 0; stroke < 2; ++stroke) {
      samples.push_back({"S1", goldenLevels()[level], stroke, 0, 0, speeds_mm_s[level][stroke]});
    }
  }
  return samples;
}

// A draw of 100 mm/s alone, or of 10 and 100, has no three clusters.
TEST(StrokeBootstrap, DrawsWithTooFewDifferentSpeedsAreDrawnAgain) {
  auto bootstrap = bootstrapOf(singleSamples({{10, 100}, {100, 100}, {100, 200}}), {10, 100, 200});
  bootstrap.add(50);
  for (const auto& centres : bootstrap.centres()) {
    EXPECT_GE(centres.front(), 10 - 1e-12);  // scaled and scaled back
    EXPECT_LE(centres.back(), 200 + 1e-12);
  }
  for (const auto& ramps : bootstrap.ramps()) {
    for (const auto& ramp : ramps) EXPECT_LT(ramp.p, ramp.q);
  }
}

// Two levels closer together than a bin of the histograms: every draw has two different speeds.
TEST(StrokeBootstrap, LevelsThatNoDrawTellsApartKeepTheParticipantsCentres) {
  auto bootstrap = bootstrapOf(singleSamples({{10, 10}, {10.001, 10.001}, {500, 500}}), {10, 10.001, 500});
  bootstrap.add(3);
  const auto found = bootstrap.intervals();
  const double wanted[] = {10, 10.001, 500};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(found.centres[k].low, wanted[k], 1e-12);  // rounding of a mean of equal draws
    EXPECT_NEAR(found.centres[k].high, wanted[k], 1e-12);
  }
}

TEST(StrokeBootstrap, BatchesAndSeeds) {
  const auto samples = goldenStrokes("S3_600.csv");
  const auto centres = centresOf("S3_600.csv");
  auto whole = bootstrapOf(samples, centres, 3);
  auto parts = bootstrapOf(samples, centres, 3);
  EXPECT_EQ(parts.replicates(), 0U);
  EXPECT_TRUE(parts.intervals().centres.empty());
  whole.add(60);
  parts.add(1);
  EXPECT_EQ(parts.intervals().centres.size(), 3U);  // an interval of one replicate, at once
  parts.add(39);
  parts.add(20);
  expectEqual(whole.intervals(), parts.intervals());
  auto other = bootstrapOf(samples, centres, 4);
  other.add(60);
  EXPECT_NE(other.intervals().centres[0].low, whole.intervals().centres[0].low);
}

TEST(StrokeBootstrap, OneStrokeOfALevelIsRefused) {
  auto samples = goldenStrokes("S3_600.csv");
  std::erase_if(samples, [](const study::SpeedSample& s) { return s.level == "medium" && s.stroke != 2; });
  const auto found = StrokeBootstrap::of(samples, goldenLevels(), centresOf("S3_600.csv"), SpeedTermSettings{}, 1);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().message(),
            "speeds of participant S3, level medium: found 1 stroke, wanted at least 2 strokes of each level for an "
            "interval");
}

TEST(StrokeBootstrap, DrawsWithTooFewSpeedsAreDrawnAgain) {
  // Three speeds in all, one of them in one stroke only: half of the draws cannot hold three clusters.
  std::vector<study::SpeedSample> samples;
  for (const auto& [level, stroke, speed] : std::vector<std::tuple<std::string, int, double>>{
           {"slow", 1, 10}, {"slow", 2, 10}, {"medium", 1, 10}, {"medium", 2, 20}, {"fast", 1, 30}, {"fast", 2, 30}}) {
    samples.push_back({"S1", level, stroke, 0, 0, speed});
  }
  auto bootstrap = bootstrapOf(samples, {10, 20, 30});
  bootstrap.add(50);
  for (const auto& centres : bootstrap.centres()) {
    EXPECT_GE(centres.front(), 10);
    EXPECT_LE(centres.back(), 30);
  }
}

}  // namespace
}  // namespace tactus::elicitation
