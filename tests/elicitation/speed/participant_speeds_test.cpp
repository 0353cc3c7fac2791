#include "elicitation/speed/participant_speeds.h"

#include <gtest/gtest.h>

#include "tests/elicitation/golden_speeds.h"
#include "tests/support/default_procedure.h"

namespace tactus::elicitation {
namespace {

const fuzzy::Variable& speed() {
  static const fuzzy::Variable kSpeed = support::ngtInputs()[3];
  return kSpeed;
}

study::Study studyOf(const std::string& file) {
  study::Study study;
  study.speeds = goldenStrokes(file);
  study.participants.push_back({.code = study.speeds.front().participant,
                                .years_experience = std::nullopt,
                                .category = {},
                                .handedness = {},
                                .weight = std::nullopt,
                                .simulated = true});
  return study;
}

SpeedTermSettings levelMeanSettings() {
  SpeedTermSettings settings;
  settings.centres = SpeedCentres::kLevelMeans;
  return settings;
}

TEST(ParticipantSpeeds, ClustersAndRampsEqualTheReference) {
  for (const auto& wanted : goldenSpeeds("subjects")) {
    const auto study = studyOf(wanted.at("file").get<std::string>());
    for (const auto& [alpha, ramps] : wanted.at("ramps").items()) {
      SpeedTermSettings settings;
      settings.alpha = base::parseNumber(alpha).value();
      const auto found = clusterSpeeds(study, speed(), settings);
      ASSERT_TRUE(found);
      const auto& one = found->front();
      ASSERT_TRUE(one.clusters);
      for (std::size_t k = 0; k < 3; ++k) {
        // The reference's plain iteration stops at steps of 1e-10, a few hundred steps' worth from the end.
        EXPECT_NEAR(one.centres[k], wanted.at("centres")[k].get<double>(), 1e-7);
      }
      for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_NEAR(one.ramps[k].p, ramps[k][0].get<double>(), 1e-7);
        EXPECT_NEAR(one.ramps[k].q, ramps[k][1].get<double>(), 1e-7);
      }
    }
  }
}

TEST(ParticipantSpeeds, LevelMeansAreCentresWhenAskedFor) {
  const auto reference = goldenSubject("S4_600.csv");
  SpeedTermSettings settings = levelMeanSettings();
  settings.alpha = 1;
  const auto found = clusterSpeeds(studyOf("S4_600.csv"), speed(), settings);
  ASSERT_TRUE(found) << found.error().message();
  const auto& one = found->front();
  EXPECT_FALSE(one.clusters);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(one.centres[k], reference.at("level_means")[k].get<double>(), 1e-10);  // sums in another order
  }
  // alpha = 1: the ramps go from center to center, whatever m.
  EXPECT_EQ(one.ramps, (std::vector<Ramp>{{one.centres[0], one.centres[1]}, {one.centres[1], one.centres[2]}}));
  EXPECT_EQ(name(SpeedCentres::kLevelMeans), "level_means");
  EXPECT_EQ(name(SpeedCentres::kClusters), "clusters");
}

TEST(ParticipantSpeeds, LevelMeansAreOfTheSamplesKept) {
  study::Study study = studyOf("S4_600.csv");
  for (auto& sample : study.speeds)
    sample.speed_mm_s = sample.level == "slow" ? 10 : sample.level == "medium" ? 20 : 30;
  // One sample of a slow stroke at a tenth of its peak goes with a trim of 0.2.
  study.speeds.front().speed_mm_s = 1;
  SpeedTermSettings settings = levelMeanSettings();
  settings.trim = 0.2;
  const auto found = clusterSpeeds(study, speed(), settings);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->front().samples, 600U);
  EXPECT_EQ(found->front().kept, 599U);
  EXPECT_EQ(found->front().centres, (std::vector<double>{10, 20, 30}));
}

TEST(ParticipantSpeeds, LevelMeansThatDoNotRiseAreRefused) {
  study::Study study = studyOf("S4_600.csv");
  for (auto& sample : study.speeds)
    sample.speed_mm_s = sample.level == "slow" ? 20 : sample.level == "medium" ? 20 : 30;
  auto found = clusterSpeeds(study, speed(), levelMeanSettings());
  ASSERT_FALSE(found);
  EXPECT_NE(
      found.error().message().find("speeds of participant S4, level means: found slow 20, medium 20, fast 30 mm/s"),
      std::string::npos)
      << found.error().message();

  std::erase_if(study.speeds, [](const study::SpeedSample& sample) { return sample.level == "medium"; });
  found = clusterSpeeds(study, speed(), levelMeanSettings());
  ASSERT_FALSE(found);
  EXPECT_NE(found.error().message().find("speeds of participant S4, level medium: found no samples"), std::string::npos)
      << found.error().message();
}

TEST(ParticipantSpeeds, LevelMeansNeedAFuzzinessToo) {
  SpeedTermSettings settings = levelMeanSettings();
  settings.fcm.m = 1;
  const auto found = clusterSpeeds(studyOf("S4_600.csv"), speed(), settings);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().place, "fuzziness m");
}

}  // namespace
}  // namespace tactus::elicitation
