#include "experiments/stroke_segmentation.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

#include "core/base/random.h"

#include "tests/experiments/simulated_stream.h"

namespace tactus::experiments {
namespace {

constexpr double kEdgeS = 0.010;

/// A noiseless hand at 1 kHz, made of rests and of movements of constant speed.
class Hand {
 public:
  Hand& rest(double seconds) { return move(0, seconds); }
  Hand& move(double way_mm, double seconds) {
    const auto count = std::lround(seconds * 1000);
    const double from_mm = position_mm_;
    for (long i = 1; i <= count; ++i) {
      position_mm_ = from_mm + way_mm * static_cast<double>(i) / static_cast<double>(count);
      add();
    }
    return *this;
  }
  Hand& lose(double seconds) {
    skipped_s_ += seconds;
    return *this;
  }
  std::vector<Stroke> strokes(const StrokeSettings& settings = {}) const { return *findStrokes(samples_, settings); }
  const std::vector<PositionSample>& samples() const { return samples_; }

 private:
  void add() { samples_.push_back({static_cast<double>(samples_.size()) / 1000 + skipped_s_, position_mm_}); }

  std::vector<PositionSample> samples_;
  double position_mm_ = 0;
  double skipped_s_ = 0;
};

void expectTrueStrokes(const SimulatedStream& stream, const std::string& what) {
  const auto found = findStrokes(stream.samples);
  ASSERT_TRUE(found.has_value());
  ASSERT_EQ(found->size(), stream.strokes.size()) << what;
  for (std::size_t i = 0; i < found->size(); ++i) {
    const Stroke& stroke = (*found)[i];
    EXPECT_NEAR(stroke.start_s, stream.strokes[i].start_s, kEdgeS) << what << ", stroke " << i;
    EXPECT_NEAR(stroke.end_s, stream.strokes[i].end_s, kEdgeS) << what << ", stroke " << i;
    EXPECT_EQ(stroke.verdict, StrokeVerdict::kAccepted) << what << ", stroke " << i;
    EXPECT_NEAR(stroke.lengthMm(), stream.strokes[i].length_mm, 1.5) << what;  // tremor of 0.3 mm, 10 ms at the ends
    const auto& samples = stream.samples;
    EXPECT_GE(samples[stroke.first].time_s, stroke.start_s);
    EXPECT_LT(samples[stroke.first - 1].time_s, stroke.start_s);
    EXPECT_LT(samples[stroke.last - 1].time_s, stroke.end_s);
    EXPECT_GE(samples[stroke.last].time_s, stroke.end_s);
  }
}

// Ground truth: where the commanded speed passes 10 mm/s (simulated_stream.h). The long run is segmentation_soak.
TEST(StrokeSegmentation, FindsEveryStrokeWithItsEdgesAndInventsNone) {
  for (std::uint64_t seed = 1; seed <= 16; ++seed) {
    expectTrueStrokes(simulatedStream(seed), "seed " + std::to_string(seed));
  }
}

TEST(StrokeSegmentation, WorksForStrongTremorNoiseAndUnevenSamples) {
  StreamRecipe recipe;
  recipe.noise_mm = 0.05;
  recipe.tremor_least_mm = 0.3;
  recipe.uneven = true;
  for (std::uint64_t seed = 101; seed <= 104; ++seed) {
    expectTrueStrokes(simulatedStream(seed, recipe), "seed " + std::to_string(seed));
  }
}

TEST(StrokeSegmentation, WorksForACleanHand) {
  StreamRecipe recipe;
  recipe.noise_mm = 0;
  recipe.count_mm = 0;
  recipe.tremor_least_mm = recipe.tremor_most_mm = 0;
  for (std::uint64_t seed = 201; seed <= 203; ++seed) {
    expectTrueStrokes(simulatedStream(seed, recipe), "seed " + std::to_string(seed));
  }
}

TEST(StrokeSegmentation, StreamingAndOfflineAgreeToTheBit) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto stream = simulatedStream(seed);
    StrokeFinder finder;
    std::vector<Stroke> live;
    std::size_t before_end = 0;
    for (const auto& sample : stream.samples) {
      finder.add(sample);
      while (const auto stroke = finder.take()) live.push_back(*stroke);
    }
    before_end = live.size();
    finder.finish();
    while (const auto stroke = finder.take()) live.push_back(*stroke);
    EXPECT_EQ(live, *findStrokes(stream.samples));
    EXPECT_GE(before_end, live.size() - 1);  // all but the last one came while the hand went on
  }
}

TEST(StrokeSegmentation, ARestingHandWithTremorMakesNoStroke) {
  for (const double hz : {8.0, 10.0, 12.0}) {
    base::Random random(7);
    std::vector<PositionSample> samples;
    for (int i = 0; i < 20000; ++i) {
      const double t = i / 1000.0;
      const double position = 0.3 * std::sin(2 * std::numbers::pi * hz * t) + 0.05 * random.normal() + 2 * t;
      samples.push_back({t, 0.055 * std::round(position / 0.055)});  // drifts by 2 mm/s on top
    }
    EXPECT_TRUE(findStrokes(samples)->empty()) << hz << " Hz";
  }
}

TEST(StrokeSegmentation, NamesWhatIsTooShortOrTooBrief) {
  StrokeSettings settings;
  settings.briefest_s = 0.3;
  const auto strokes =
      Hand().rest(0.5).move(12, 0.3).rest(0.6).move(-12, 0.3).rest(0.5).move(60, 0.2).rest(1).strokes(settings);
  ASSERT_EQ(strokes.size(), 2U);
  EXPECT_EQ(strokes[0].verdict, StrokeVerdict::kTooShort);
  EXPECT_NEAR(strokes[0].lengthMm(), 12, 0.2);
  EXPECT_EQ(strokes[1].verdict, StrokeVerdict::kTooBrief);
  EXPECT_NEAR(strokes[1].durationS(), 0.2, 2 * kEdgeS);
}

TEST(StrokeSegmentation, FidgetingIsNoStroke) {
  EXPECT_TRUE(Hand().rest(0.5).move(4, 0.1).rest(0.5).move(-4, 0.1).rest(0.5).strokes().empty());
}

TEST(StrokeSegmentation, AReturnIsNoStrokeButGoingBackFirstIs) {
  const auto returned = Hand().rest(0.5).move(60, 0.6).rest(0.4).move(-70, 0.5).rest(0.5).strokes();
  ASSERT_EQ(returned.size(), 1U);
  EXPECT_EQ(returned[0].verdict, StrokeVerdict::kAccepted);

  const auto first = Hand().rest(0.5).move(-45, 0.5).rest(0.5).strokes();
  ASSERT_EQ(first.size(), 1U);
  EXPECT_EQ(first[0].verdict, StrokeVerdict::kBackwards);
  EXPECT_NEAR(first[0].lengthMm(), -45, 1);
  // Going forward again from there is a stroke like any other.
  const auto both = Hand().rest(0.5).move(-45, 0.5).rest(0.5).move(60, 0.6).rest(1).strokes();
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(both[1].verdict, StrokeVerdict::kAccepted);
}

TEST(StrokeSegmentation, AShortPauseBelongsToTheStrokeALongOneEndsIt) {
  const auto joined = Hand().rest(0.5).move(35, 0.4).rest(0.15).move(35, 0.4).rest(1).strokes();
  ASSERT_EQ(joined.size(), 1U);
  EXPECT_NEAR(joined[0].lengthMm(), 70, 1);
  EXPECT_NEAR(joined[0].durationS(), 0.95, 2 * kEdgeS);
  const auto split = Hand().rest(0.5).move(35, 0.4).rest(0.6).move(35, 0.4).rest(1).strokes();
  ASSERT_EQ(split.size(), 2U);
  EXPECT_NEAR(split[0].lengthMm(), 35, 1);
}

TEST(StrokeSegmentation, ASmallReversalBelongsToTheStrokeALargeOneEndsIt) {
  const auto joined = Hand().rest(0.5).move(35, 0.4).move(-2, 0.05).move(35, 0.4).rest(1).strokes();
  ASSERT_EQ(joined.size(), 1U);
  EXPECT_NEAR(joined[0].lengthMm(), 68, 1);
  const auto split = Hand().rest(0.5).move(35, 0.4).move(-15, 0.15).move(35, 0.4).rest(1).strokes();
  ASSERT_EQ(split.size(), 2U);
}

TEST(StrokeSegmentation, NamesAStrokeThatLeavesTheRange) {
  StrokeSettings settings;
  settings.lowest_mm = -20;
  settings.highest_mm = 50;
  const auto strokes =
      Hand().rest(0.5).move(45, 0.5).rest(0.5).move(-45, 0.5).rest(0.5).move(60, 0.5).rest(1).strokes(settings);
  ASSERT_EQ(strokes.size(), 2U);
  EXPECT_EQ(strokes[0].verdict, StrokeVerdict::kAccepted);
  EXPECT_EQ(strokes[1].verdict, StrokeVerdict::kOutOfRange);
}

TEST(StrokeSegmentation, NamesAStrokeWithAGapOrWithoutAnEnd) {
  const auto gap = Hand().rest(0.5).move(40, 0.4).lose(0.2).move(40, 0.4).rest(1).strokes();
  ASSERT_EQ(gap.size(), 2U);
  EXPECT_EQ(gap[0].verdict, StrokeVerdict::kInterrupted);
  const auto open = Hand().rest(0.5).move(60, 0.6).strokes();
  ASSERT_EQ(open.size(), 1U);
  EXPECT_EQ(open[0].verdict, StrokeVerdict::kInterrupted);
  // A gap while nothing moves does no harm.
  const auto quiet = Hand().rest(0.5).lose(0.5).rest(0.5).move(60, 0.6).rest(1).strokes();
  ASSERT_EQ(quiet.size(), 1U);
  EXPECT_EQ(quiet[0].verdict, StrokeVerdict::kAccepted);
}

TEST(StrokeSegmentation, SamplesThatCannotBeAreLeftOutButCounted) {
  auto samples = Hand().rest(0.5).move(60, 0.6).rest(1).samples();
  const auto clean = *findStrokes(samples);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  samples.insert(samples.begin() + 100, {{0.1, nan}, {nan, 0}, {0.05, 999}});
  const auto dirty = *findStrokes(samples);
  ASSERT_EQ(dirty.size(), 1U);
  EXPECT_EQ(dirty[0].start_s, clean[0].start_s);
  EXPECT_EQ(dirty[0].first, clean[0].first + 3);
  EXPECT_EQ(dirty[0].last, clean[0].last + 3);
}

TEST(StrokeSegmentation, AnyNumbersAreSurvived) {
  base::Random random(11);
  for (int round = 0; round < 5; ++round) {
    StrokeFinder finder;
    double time_s = 0;
    for (int i = 0; i < 2000; ++i) {
      const double size = std::pow(10.0, random.uniform(-3, round == 4 ? 300 : 2.0 * round));
      time_s += random.uniform(-0.0005, 0.004);
      finder.add({time_s, random.uniform(-size, size)});
    }
    finder.finish();
    while (const auto stroke = finder.take()) {
      EXPECT_LE(stroke->first, stroke->last);
      EXPECT_LE(stroke->start_s, stroke->end_s);
    }
  }
}

TEST(StrokeSegmentation, AMouseIsEnough) {
  const auto fine = Hand().rest(0.5).move(60, 0.6).rest(1).samples();
  base::Random random(3);
  std::vector<PositionSample> coarse;
  for (std::size_t i = 0; i < fine.size(); i += static_cast<std::size_t>(8 + random.below(15))) {
    coarse.push_back(fine[i]);
  }
  const auto strokes = *findStrokes(coarse);
  ASSERT_EQ(strokes.size(), 1U);
  EXPECT_NEAR(strokes[0].start_s, 0.5, 0.022);  // the longest step between two samples
  EXPECT_NEAR(strokes[0].end_s, 1.1, 0.022);
}

TEST(StrokeSegmentation, NothingComesOfNothing) {
  EXPECT_TRUE(findStrokes({})->empty());
  const PositionSample one{0, 0};
  EXPECT_TRUE(findStrokes({&one, 1})->empty());
  StrokeSettings wrong;
  wrong.stop_speed_mm_s = 50;
  EXPECT_FALSE(findStrokes({}, wrong).has_value());
}

}  // namespace
}  // namespace tactus::experiments
