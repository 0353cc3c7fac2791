#include "elicitation/model/speed_bootstrap.h"

#include <gtest/gtest.h>

#include "tests/elicitation/golden_speeds.h"

namespace tactus::elicitation {
namespace {

/// Experts with rules and the strokes of the golden files.
study::Study studyOf(const std::vector<std::string>& files) {
  study::Study study;
  for (const auto& file : files) {
    const auto samples = goldenStrokes(file);
    study.speeds.insert(study.speeds.end(), samples.begin(), samples.end());
    study::Participant participant;
    participant.code = samples.front().participant;
    participant.simulated = true;
    study.participants.push_back(participant);
    study::GivenRule rule;
    rule.participant = participant.code;
    rule.conditions = {{"speed", "slow"}};
    rule.then = "small";
    study.rules.push_back(rule);
  }
  return study;
}

BuiltModel built(const study::Study& study, const BuildSettings& settings) {
  auto result = buildModel(study, {}, settings);
  EXPECT_TRUE(result) << (result ? "" : result.error().message());
  return std::move(*result);
}

TEST(SpeedBootstrap, OneParticipantIsTheAverage) {
  const auto study = studyOf({"S3_600.csv"});
  const BuildSettings settings;
  auto bootstrap = SpeedBootstrap::of(study, built(study, settings), settings).value();
  EXPECT_TRUE(bootstrap.intervals().averaged.empty());
  bootstrap.add(50);
  const auto found = bootstrap.intervals();
  ASSERT_EQ(found.averaged.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(found.averaged[k].p.low, found.participants[0].ramps[k].p.low);
    EXPECT_EQ(found.averaged[k].q.high, found.participants[0].ramps[k].q.high);
  }
}

TEST(SpeedBootstrap, AverageIsTakenReplicateByReplicate) {
  const auto study = studyOf({"S1_600.csv", "S3_600.csv", "S4_600.csv"});
  const BuildSettings settings;
  const auto model = built(study, settings);
  auto bootstrap = SpeedBootstrap::of(study, model, settings).value();
  bootstrap.add(300);
  EXPECT_EQ(bootstrap.replicates(), 300U);
  const auto found = bootstrap.intervals();
  ASSERT_EQ(found.participants.size(), 3U);
  for (std::size_t k = 0; k < 2; ++k) {
    double mean_width = 0;
    for (const auto& one : found.participants) mean_width += (one.ramps[k].q.high - one.ramps[k].q.low) / 3;
    const double width = found.averaged[k].q.high - found.averaged[k].q.low;
    // Independent participants: the average varies less than they do in the mean, and at least a third as much as the
    // one who varies most.
    EXPECT_LT(width, mean_width);
    EXPECT_GT(width, mean_width / 3);
    EXPECT_LT(found.averaged[k].q.low, model.averaged_ramps[k].q);
    EXPECT_GT(found.averaged[k].q.high, model.averaged_ramps[k].q);
  }
}

TEST(SpeedBootstrap, WeightsAreThoseOfTheBuild) {
  auto study = studyOf({"S1_600.csv", "S4_600.csv"});
  study.participants[0].weight = 0;
  study.participants[1].weight = 2;
  BuildSettings settings;
  settings.averaging = Averaging::kWeightedMean;
  settings.weights.policy = WeightPolicy::kColumn;
  auto bootstrap = SpeedBootstrap::of(study, built(study, settings), settings).value();
  bootstrap.add(40);
  const auto found = bootstrap.intervals();
  // 0 and 2 of 2 leave S4 alone, but for the rounding of (0 + 2 x) / 2.
  EXPECT_DOUBLE_EQ(found.averaged[1].p.low, found.participants[1].ramps[1].p.low);
}

TEST(SpeedBootstrap, CanBeStoppedBeforeEachParticipant) {
  const auto study = studyOf({"S1_600.csv", "S3_600.csv", "S4_600.csv"});
  const BuildSettings settings;
  const auto model = built(study, settings);
  int asked = 0;
  const auto stopped = SpeedBootstrap::of(study, model, settings, 1, [&asked] { return ++asked < 2; });
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, base::ErrorCode::kCancelled);
  EXPECT_EQ(asked, 2) << "nothing is prepared after the answer to stop";
  EXPECT_TRUE(SpeedBootstrap::of(study, model, settings, 1, [] { return true; }));
}

TEST(SpeedBootstrap, ParticipantsOneByOneGiveTheSame) {
  const auto study = studyOf({"S1_600.csv", "S3_600.csv", "S4_600.csv"});
  const BuildSettings settings;
  const auto model = built(study, settings);
  auto together = SpeedBootstrap::of(study, model, settings).value();
  together.add(30);
  auto alone = SpeedBootstrap::of(study, model, settings).value();
  ASSERT_EQ(alone.participants(), 3U);
  for (const std::size_t participant : {2U, 0U, 1U}) alone.addTo(participant, 30);
  EXPECT_EQ(alone.replicates(), 30U);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(alone.intervals().averaged[k].p.low, together.intervals().averaged[k].p.low);
    EXPECT_EQ(alone.intervals().participants[2].ramps[k].q.high, together.intervals().participants[2].ramps[k].q.high);
  }
}

TEST(SpeedBootstrap, NoSpeedsAreRefused) {
  auto study = studyOf({"S1_600.csv"});
  study.speeds.clear();
  const BuildSettings settings;
  const auto found = SpeedBootstrap::of(study, built(study, settings), settings);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().place, "speeds");
}

}  // namespace
}  // namespace tactus::elicitation
