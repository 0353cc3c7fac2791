#include "app/workbench/labs/speed/speed_clusters.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <gtest/gtest.h>
#include <iostream>

#include "app/session/study_view.h"
#include "app/workbench/labs/speed/speed_lab.h"

#include "tests/gui/labs/lab_study_file.h"
#include "tests/gui/sample_study.h"
#include "tests/support/default_procedure.h"

namespace tactus::workbench {
namespace {

bool always(double) { return true; }

class SpeedClustersTest : public testing::Test {
 protected:
  static std::shared_ptr<const LabStudy> demo() {
    static const auto study = [] {
      const QTemporaryDir folder;
      auto read = readLabStudy(tests::lookInto(tests::demoStudyIn(folder)));
      EXPECT_TRUE(read.has_value());
      return std::make_shared<const LabStudy>(std::move(*read));
    }();
    return study;
  }
  static fuzzy::Variable speed() {
    for (const auto& input : support::ngtInputs()) {
      if (input.id == "speed") return input;
    }
    return {};
  }
  static std::size_t warningsOf(const SpeedResult& result, const std::string& participant) {
    for (const auto& subject : result.subjects) {
      if (subject->speeds.participant == participant) return subject->speeds.diagnostics.warnings.size();
    }
    ADD_FAILURE();
    return 0;
  }

  SpeedClusters clusters;
  elicitation::BuildSettings settings;
};

TEST_F(SpeedClustersTest, EachSettingGivesWhatTheModelGets) {
  struct Case {
    double alpha, m, trim;
    elicitation::SpeedCentres centres;
  };
  using enum elicitation::SpeedCentres;
  // In this order, so that what is kept between them is used.
  const std::vector<Case> cases = {{0.95, 2, 0, kClusters},   {0.75, 2, 0, kClusters},     {0.75, 1.5, 0, kClusters},
                                   {0.95, 2, 0.4, kClusters}, {0.95, 2, 0.4, kLevelMeans}, {0.95, 2, 0, kClusters}};
  for (const Case& one : cases) {
    settings.speed.alpha = one.alpha;
    settings.speed.fcm.m = one.m;
    settings.speed.trim = one.trim;
    settings.speed.centres = one.centres;
    ASSERT_TRUE(clusters.cluster(demo(), settings, 3, always));
    const auto result = clusters.check(always);
    ASSERT_TRUE(result);
    const auto wanted = elicitation::clusterSpeeds(demo()->study, speed(), settings.speed);
    ASSERT_TRUE(wanted);
    ASSERT_EQ(result->subjects.size(), wanted->size());
    std::vector<std::vector<elicitation::Ramp>> ramps;
    for (std::size_t i = 0; i < wanted->size(); ++i) {
      const auto& found = result->subjects[i]->speeds;
      EXPECT_EQ(found.participant, (*wanted)[i].participant);
      EXPECT_EQ(found.kept, (*wanted)[i].kept);
      EXPECT_EQ(found.centres, (*wanted)[i].centres);
      EXPECT_EQ(found.ramps, (*wanted)[i].ramps);
      EXPECT_EQ(found.validity.partition_entropy, (*wanted)[i].validity.partition_entropy);
      EXPECT_EQ(found.diagnostics.warnings, (*wanted)[i].diagnostics.warnings);
      ramps.push_back((*wanted)[i].ramps);
    }
    EXPECT_EQ(result->averaged, elicitation::averageRamps(ramps, {}, elicitation::Averaging::kMean));
  }
}

// facts/elicitation.md 2: for S2 and S4 the cluster "slow" is the start and stop of each stroke.
TEST_F(SpeedClustersTest, TheWarningsAreForS2AndS4AlonAndTheirLevelsReadAsOne) {
  ASSERT_TRUE(clusters.cluster(demo(), settings, 3, always));
  const auto result = clusters.check(always);
  ASSERT_TRUE(result);
  EXPECT_EQ(warningsOf(*result, "S1"), 0U);
  EXPECT_GT(warningsOf(*result, "S2"), 0U);
  EXPECT_EQ(warningsOf(*result, "S3"), 0U);
  EXPECT_GT(warningsOf(*result, "S4"), 0U);
  ASSERT_FALSE(result->same_terms.empty());
  EXPECT_NE(result->same_terms.back().find("S4"), std::string::npos);
}

TEST_F(SpeedClustersTest, AnotherNumberOfClustersAveragesNothing) {
  const auto result = clusters.cluster(demo(), settings, 5, always);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->subjects.front()->speeds.centres.size(), 5U);
  EXPECT_TRUE(result->averaged.empty());
  const auto checked = clusters.check(always);
  ASSERT_TRUE(checked);
  EXPECT_TRUE(checked->subjects.front()->speeds.diagnostics.warnings.empty());
  EXPECT_EQ(checked->subjects.front()->speeds.diagnostics.levels.size(), 3U);  // Table 1 stays
}

TEST(SideBySide, EachPieceIsDoneOnceAndAnAnswerToStopEndsIt) {
  std::vector<std::atomic<int>> done(500);
  double told = 0;
  EXPECT_TRUE(sideBySide(
      done.size(), [&](std::size_t i) { ++done[i]; },
      [&](double share) {
        EXPECT_TRUE(share >= 0 && share <= 1);
        told = share;
        return true;
      }));
  EXPECT_EQ(told, 1);
  for (const auto& times : done) EXPECT_EQ(times, 1);

  std::atomic<int> pieces = 0;
  EXPECT_FALSE(sideBySide(
      1000, [&](std::size_t) { ++pieces; }, [](double) { return false; }));
  EXPECT_EQ(pieces, 0);
}

TEST_F(SpeedClustersTest, TheIntervalsAreThoseOfWholeStrokes) {
  ASSERT_TRUE(clusters.cluster(demo(), settings, 3, always));
  ASSERT_TRUE(clusters.check(always));
  std::shared_ptr<const SpeedResult> last;
  clusters.bootstrap([&](double) { return !last; }, [&](auto result) { last = std::move(result); });
  ASSERT_TRUE(last && last->intervals);
  // facts/elicitation.md 1, S1: [41.5, 51.4]; other simulated strokes, so only about as wide.
  const auto interval = last->intervals->participants.front().centres.front();
  EXPECT_GT(interval.high - interval.low, 4);
  EXPECT_LT(interval.high - interval.low, 40);
}

TEST_F(SpeedClustersTest, AStudyWithoutSpeedsHasNoSubjects) {
  const auto result = clusters.cluster(std::make_shared<const LabStudy>(), settings, 3, always);
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->subjects.empty());
  EXPECT_TRUE(result->averaged.empty());
}

TEST_F(SpeedClustersTest, AStoppedRunGivesNothing) {
  EXPECT_FALSE(clusters.cluster(demo(), settings, 3, [](double) { return false; }));
}

TEST(ObjectiveTraceTest, JFallsWithEachIterationToTheMinimum) {
  // Two groups around 10 and 20; by symmetry the centers are at 15 ± d, and J is the same from both sides.
  std::vector<double> samples;
  for (int i = -4; i <= 4; ++i) {
    samples.push_back(10 + 0.1 * i);
    samples.push_back(20 + 0.1 * i);
  }
  const ObjectiveTrace trace = objectiveTrace(samples, 2, 2, [] { return true; });
  ASSERT_GE(trace.objective.size(), 2U);
  EXPECT_TRUE(trace.converged);
  EXPECT_TRUE(std::is_sorted(trace.objective.rbegin(), trace.objective.rend()));
  const auto found = elicitation::fuzzyCMeans(samples, {.clusters = 2});
  ASSERT_TRUE(found && found->objective);
  // The alternation ends a millionth of the range from the minimum, where J is flat.
  EXPECT_NEAR(trace.objective.back(), *found->objective, 1e-9 * *found->objective);
  EXPECT_TRUE(objectiveTrace({}, 2, 2, [] { return true; }).objective.empty());
}

}  // namespace
}  // namespace tactus::workbench
