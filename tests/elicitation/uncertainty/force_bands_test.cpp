// Against exact enumerations by another program: four participants with the judgements that Table 2 splits into, paired
// with the rules of three invented experts and S4.
#include "elicitation/uncertainty/force_bands.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "tests/elicitation/four_people.h"

namespace tactus::elicitation {
namespace {

const std::vector<std::vector<double>> kPoints = {
    {1, 60, 70, 50}, {1, 60, 200, 50}, {1, 60, 300, 50}, {.3, 45, 170, 80}};
constexpr std::size_t kA = 1;        // place of (1, 60, 200, 50)
constexpr double kPrinted = 5.1e-6;  // half of the last digit printed, and rounding

/// Ramps from the centers of domain facts 5.4 instead of strokes.
void giveRamps(BuiltModel& built) {
  const std::vector<std::vector<double>> centres = {
      {43.7, 145.5, 308.0}, {23.9, 140.9, 226.0}, {54.5, 112.8, 193.9}, {5.8, 35.4, 53.3}};
  std::vector<std::vector<Ramp>> all;
  for (std::size_t i = 0; i < 4; ++i) {
    ParticipantSpeeds speeds;
    speeds.participant = built.model.experts[i].id;
    speeds.ramps = alphaCutRamps(centres[i], 2, kDefaultAlpha).value();
    all.push_back(speeds.ramps);
    built.speeds.push_back(std::move(speeds));
  }
  built.averaged_ramps = averageRamps(all, {}, Averaging::kMean);
  auto& speed = built.model.inputs[3];
  speed.terms = speedTerms(speed, built.averaged_ramps);
}

ForceBands bandsOf(const study::Study& study, const BuiltModel& built, BuildSettings settings, std::size_t again = 0) {
  auto bands = ForceBands::of(study, built, settings, {.points = kPoints, .replicates = again, .again = again > 0});
  EXPECT_TRUE(bands) << bands.error().message();
  while (bands->add(100)) {
  }
  EXPECT_EQ(bands->done(), bands->planned());
  return std::move(*bands);
}

void expectDrawn(const std::vector<DrawnForce>& drawn, const std::vector<double>& mean_n,
                 const std::vector<double>& sd_n, double tolerance = kPrinted) {
  ASSERT_EQ(drawn.size(), mean_n.size());
  for (std::size_t p = 0; p < drawn.size(); ++p) {
    EXPECT_NEAR(drawn[p].mean_n, mean_n[p], tolerance) << p;
    EXPECT_NEAR(drawn[p].sd_n, sd_n[p], tolerance) << p;
    EXPECT_NEAR(drawn[p].abstains, 0, 1e-12) << p;
  }
}

TEST(ForceBands, RulesAndVotesDrawnAloneGiveTheEnumeratedNumbers) {
  const auto study = fourPeople();
  const auto built = buildModel(study, {}, {});
  ASSERT_TRUE(built) << built.error().message();
  const auto bands = bandsOf(study, *built, {});
  expectDrawn(bands.drawn(Drawn::kWhoAnswered), {.31267, .53486, .49841, .68361}, {.02164, .03126, .02423, .03584});
  EXPECT_NEAR(*bands.drawnQuantile(Drawn::kWhoAnswered, kA, .025), .475, kPrinted);
  EXPECT_NEAR(*bands.drawnQuantile(Drawn::kWhoAnswered, kA, .975), .59472, kPrinted);
  expectDrawn(bands.drawn(Drawn::kWhoJudged), {.24828, .47664, .41587, .62324}, {.08934, .13080, .12622, .09070});
  EXPECT_NEAR(*bands.drawnQuantile(Drawn::kWhoJudged, kA, .025), .28792, kPrinted);
  EXPECT_NEAR(*bands.drawnQuantile(Drawn::kWhoJudged, kA, .975), .67843, kPrinted);
  EXPECT_TRUE(bands.drawn(Drawn::kWhoMoved).empty()) << "no speeds to draw from";
  EXPECT_TRUE(bands.drawn(Drawn::kWhoJudged)[kA].on_edge) << ".058 N below the estimate";
}

TEST(ForceBands, VotesDrawnUnderOneExpertGiveTheEnumeratedNumbers) {
  auto study = fourPeople();
  std::erase_if(study.rules, [](const auto& rule) { return rule.participant != "S4"; });
  const auto built = buildModel(study, {}, {});
  ASSERT_TRUE(built);
  const auto bands = bandsOf(study, *built, {});
  expectDrawn(bands.drawn(Drawn::kWhoJudged), {.27278, .56820, .51422, .61538}, {.09817, .05236, .05811, .04676});
  EXPECT_NEAR(*bands.drawnQuantile(Drawn::kWhoJudged, kA, .025), .51355, kPrinted);
  EXPECT_NEAR(*bands.drawnQuantile(Drawn::kWhoJudged, kA, .975), .66373, kPrinted);
  // A resample without S4 has no rules: 3^4 of 4^4 draws give no force.
  EXPECT_NEAR(bands.drawn(Drawn::kPeople)[kA].abstains, 81.0 / 256, 1e-12);
}

TEST(ForceBands, ParticipantsDrawnAsWholesGiveTheEnumeratedNumbers) {
  const auto study = fourPeople();
  auto built = buildModel(study, {}, {}).value();
  giveRamps(built);
  const auto bands = bandsOf(study, built, {});
  // The centers are printed with one digit: up to .05 mm/s of a ramp, below 5e-5 N.
  constexpr double kOfCentres = 5e-5;
  expectDrawn(bands.drawn(Drawn::kPeople), {.26959, .47594, .42049, .61957}, {.10952, .15757, .15289, .14535},
              kOfCentres);
  EXPECT_NEAR(*bands.drawnQuantile(Drawn::kPeople, kA, .025), .18934, kOfCentres);
  EXPECT_NEAR(*bands.drawnQuantile(Drawn::kPeople, kA, .975), .70243, kOfCentres);
  const auto others = bands.band(BandKind::kOthers);
  const std::vector<double> half_n = {.4025, .5790, .5618, .5341};
  for (std::size_t p = 0; p < half_n.size(); ++p) {
    EXPECT_NEAR(others.points[p].half_width_n, half_n[p], 2e-4) << p;  // 3.67 times the error of the deviation
    EXPECT_LE(others.points[p].low_n, *others.points[p].force_n);
    EXPECT_GE(others.points[p].high_n, *others.points[p].force_n);
    // Cut at the ends of the force, not at what these words reach: other nurses have other words.
    EXPECT_EQ(others.points[p].low_n, std::max(*others.points[p].force_n - others.points[p].half_width_n, 0.0));
    EXPECT_EQ(others.points[p].high_n,
              std::min(*others.points[p].force_n + others.points[p].half_width_n, built.model.output.max));
  }
}

TEST(ForceBands, SpeedsDrawnAloneGiveTheEnumeratedNumbers) {
  auto study = fourPeople();
  auto built = buildModel(study, {}, {}).value();
  giveRamps(built);
  const auto bands = bandsOf(study, built, {});
  expectDrawn(bands.drawn(Drawn::kWhoMoved), {.32501, .53568, .50351, .70248}, {.01409, .00697, .00963, .02137}, 5e-5);
}

TEST(ForceBands, MeanThresholdsAreSteadierThanTheVote) {
  const auto study = fourPeople();
  BuildSettings settings;
  settings.force_terms = ForceTermsFrom::kThresholds;
  auto built = buildModel(study, {}, settings).value();
  giveRamps(built);
  const auto bands = bandsOf(study, built, settings);
  expectDrawn(bands.drawn(Drawn::kPeople), {.28435, .49186, .43056, .63376}, {.07948, .11045, .10820, .09992}, 5e-5);
  const auto others = bands.band(BandKind::kOthers);
  EXPECT_NEAR(others.points[kA].half_width_n, .4059, 2e-4);
}

TEST(ForceBands, TheNextExpertLiesAroundTheMeanByTheSpreadOfTheExperts) {
  const auto study = fourPeople();
  const auto built = buildModel(study, {}, {}).value();
  const auto bands = bandsOf(study, built, {});
  const auto next = bands.band(BandKind::kNext);
  ASSERT_EQ(next.points.size(), 4U);
  EXPECT_NEAR(*next.points[kA].force_n, .534861, 5e-7);
  EXPECT_NEAR(next.points[kA].half_width_n, .2569, 5e-5);
  EXPECT_FALSE(next.not_included.empty());
}

// The same four judging once more, with the noise of one just-noticeable difference: 4,000 runs of another program gave
// standard deviations of .053 .052 .067 .047 N under the vote, .013 .015 .018 .013 N with mean thresholds.
TEST(ForceBands, JudgingOnceMoreMovesTheVoteMoreThanTheThresholds) {
  const auto study = fourPeople();
  for (const auto from : {ForceTermsFrom::kVote, ForceTermsFrom::kThresholds}) {
    BuildSettings settings;
    settings.force_terms = from;
    const auto built = buildModel(study, {}, settings).value();
    const auto bands = bandsOf(study, built, settings, 2000);
    const auto drawn = bands.drawn(Drawn::kOwnJudgements);
    const std::vector<double> sd_n = from == ForceTermsFrom::kVote ? std::vector<double>{.053, .052, .067, .047}
                                                                   : std::vector<double>{.013, .015, .018, .013};
    for (std::size_t p = 0; p < sd_n.size(); ++p) {
      // 2,000 draws against 4,000: 2 % each; half of the last digit.
      EXPECT_NEAR(drawn[p].sd_n, sd_n[p], 0.06 * sd_n[p] + 5e-4) << p;
    }
    const auto again = bands.band(BandKind::kAgain);
    EXPECT_NEAR(again.points[kA].half_width_n, 1.96 * drawn[kA].sd_n, 1e-4 * drawn[kA].sd_n + 1e-6);
    EXPECT_EQ(again.assumed.size(), 1U);
    EXPECT_EQ(again.not_included.size(), 2U) << "strokes and answers";
  }
}

TEST(ForceBands, LeavingOneOutIsACastToo) {
  const auto study = fourPeople();
  const auto built = buildModel(study, {}, {}).value();
  const ResampledStudy resample(study, built, {});
  const std::vector<double> without_n = {.563148, .513148, .380040, .300000};
  for (std::size_t who = 0; who < 4; ++who) {
    ResampleCounts counts = everyPerson(4);
    counts[who] = 0;
    const auto forces = resample.forces({counts, counts, counts}, kPoints);
    ASSERT_TRUE(forces[kA]);
    EXPECT_NEAR(*forces[kA], without_n[who], 5.1e-7) << who;
  }
  // Each person once is the study itself.
  const auto same = resample.forces({everyPerson(4), everyPerson(4), everyPerson(4)}, kPoints);
  EXPECT_NEAR(*same[kA], .534861, 5e-7);
}

TEST(ForceBands, OneParticipantHasNoOthers) {
  auto study = fourPeople();
  study.participants.resize(1);
  std::erase_if(study.rules, [](const auto& rule) { return rule.participant != "E1"; });
  std::erase_if(study.judgements, [](const auto& one) { return one.participant != "E1"; });
  const auto built = buildModel(study, {}, {}).value();
  const auto bands = bandsOf(study, built, {}, 100);
  EXPECT_TRUE(bands.band(BandKind::kOthers).points.empty());
  EXPECT_TRUE(bands.band(BandKind::kNext).points.empty());
  EXPECT_EQ(bands.band(BandKind::kAgain).points.size(), 4U);
}

// Batches of any size give the same draws.
/// fourPeople() and four more who say the same: 6,435 resamples.
study::Study eightPeople() {
  auto study = fourPeople();
  const auto again = [](auto& rows, auto code) {
    const auto before = rows;
    for (auto row : before) {
      code(row) += "b";
      rows.push_back(std::move(row));
    }
  };
  again(
      study.participants, [](auto& row) -> auto& { return row.code; });
  again(
      study.judgements, [](auto& row) -> auto& { return row.participant; });
  again(
      study.rules, [](auto& row) -> auto& { return row.participant; });
  return study;
}

// The first resamples of the enumeration hold the same few people, and made the band half as wide as it is.
TEST(ForceBands, TheFirstCastsStandForAllOfThem) {
  const auto study = eightPeople();
  const auto built = buildModel(study, {}, {});
  ASSERT_TRUE(built) << built.error().message();
  auto bands = ForceBands::of(study, *built, {}, {.points = kPoints, .again = false, .split = false});
  ASSERT_TRUE(bands) << bands.error().message();
  EXPECT_EQ(bands->planned(), 6435U);
  while (bands->done() < 200) bands->add(1);
  const auto some = bands->drawn(Drawn::kPeople);
  while (bands->add(1000)) {
  }
  const auto all = bands->drawn(Drawn::kPeople);
  for (std::size_t p = 0; p < all.size(); ++p) {
    EXPECT_NEAR(some[p].sd_n, all[p].sd_n, .25 * all[p].sd_n) << p;
    EXPECT_NEAR(some[p].mean_n, all[p].mean_n, .25 * all[p].sd_n) << p;
  }
}

TEST(ForceBands, BatchesDoNotChangeTheResult) {
  const auto study = fourPeople();
  const auto built = buildModel(study, {}, {}).value();
  const auto at_once = bandsOf(study, built, {}, 100);
  auto one_by_one = ForceBands::of(study, built, {}, {.points = kPoints, .replicates = 100}).value();
  while (one_by_one.add(1)) {
  }
  for (const auto drawn : {Drawn::kPeople, Drawn::kOwnJudgements}) {
    const auto a = at_once.drawn(drawn);
    const auto b = one_by_one.drawn(drawn);
    for (std::size_t p = 0; p < a.size(); ++p) EXPECT_EQ(a[p].sd_n, b[p].sd_n);
  }
}

TEST(ResampleCounts, EnumeratesEveryMultisetWithItsProbability) {
  const auto of_four = everyResample(4);
  EXPECT_EQ(of_four.size(), 35U);
  EXPECT_EQ(everyResample(6).size(), 462U);
  EXPECT_EQ(everyResample(8).size(), 6435U);
  double sum = 0;
  for (const auto& one : of_four) sum += one.weight;
  EXPECT_NEAR(sum, 1, 1e-12);
  const auto same = std::find_if(of_four.begin(), of_four.end(), [](const auto& one) {
    return one.counts == ResampleCounts{4, 0, 0, 0};
  });
  EXPECT_NEAR(same->weight, 1.0 / 256, 1e-15);
  const auto mixed =
      std::find_if(of_four.begin(), of_four.end(), [](const auto& one) { return one.counts == everyPerson(4); });
  EXPECT_NEAR(mixed->weight, 24.0 / 256, 1e-15);
}

}  // namespace
}  // namespace tactus::elicitation
