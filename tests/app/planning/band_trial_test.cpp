#include "app/planning/band_trial.h"

#include <gtest/gtest.h>

#include "core/procedure/procedure.h"

namespace tactus::planning {
namespace {

using elicitation::ForceTermsFrom;

TrialSettings smallTrial(int nurses) {
  TrialSettings settings;
  settings.design.nurses = nurses;
  settings.places = 2;
  settings.plan.studies = 60;
  settings.plan.population = 300;
  settings.plan.force_terms = ForceTermsFrom::kThresholds;
  return settings;
}

// The band states 95 %. 60 studies say 92 % with a standard error of 3: below 80 % it would promise what it does not
// hold. `study trial` runs 500 (docs/uncertainty.md).
TEST(BandTrial, TheTruthOfNursesThatDifferLiesInTheBand) {
  const auto questions = questionsOf(procedure::defaultProcedure());
  const auto trial = tryBands(questions, sourceOf(defaultFamily(questions)), smallTrial(4));
  ASSERT_TRUE(trial) << trial.error().message();
  EXPECT_EQ(trial->studies, 60U);
  ASSERT_EQ(trial->regions.size(), 5U);
  EXPECT_EQ(trial->regions.front().region, "nasal_cavity");
  EXPECT_GT(trial->all.covered, 0.8);
  EXPECT_LT(trial->all.low, trial->all.covered);
  EXPECT_GT(trial->all.error_n, 0.05);
  // Student's t of four is wide: the band is wider than the error.
  EXPECT_GT(trial->all.half_width_n, 1.5 * trial->all.error_n);
}

TEST(BandTrial, MoreNursesHaveANarrowerBandAndASmallerError) {
  const auto questions = questionsOf(procedure::defaultProcedure());
  const auto source = sourceOf(defaultFamily(questions));
  const auto few = tryBands(questions, source, smallTrial(3));
  const auto more = tryBands(questions, source, smallTrial(6));
  ASSERT_TRUE(few && more);
  EXPECT_LT(more->all.half_width_n, few->all.half_width_n);
  EXPECT_LT(more->all.error_n, few->all.error_n);
}

TEST(BandTrial, IsTheSameOnAnyNumberOfThreadsAndOfAnyProcedure) {
  for (const auto& id : procedure::builtInIds()) {
    const auto questions = questionsOf(procedure::builtIn(id));
    TrialSettings settings = smallTrial(3);
    settings.plan.studies = 8;
    settings.plan.population = 40;
    settings.plan.threads = 1;
    const auto one = tryBands(questions, sourceOf(defaultFamily(questions)), settings);
    settings.plan.threads = 3;
    const auto three = tryBands(questions, sourceOf(defaultFamily(questions)), settings);
    ASSERT_TRUE(one && three) << id;
    EXPECT_EQ(one->all.covered, three->all.covered) << id;
    EXPECT_EQ(one->all.error_n, three->all.error_n) << id;
    EXPECT_EQ(one->all.half_width_n, three->all.half_width_n) << id;
  }
}

TEST(BandTrial, WhatCannotBeTriedIsRefused) {
  const auto questions = questionsOf(procedure::defaultProcedure());
  const auto source = sourceOf(defaultFamily(questions));
  const auto alone = tryBands(questions, source, smallTrial(1));
  ASSERT_FALSE(alone);
  EXPECT_EQ(alone.error().message(), "nurses: found 1, wanted 2 to 200: one nurse has no band");
  const auto canceled = tryBands(questions, source, smallTrial(4), [](double) { return false; });
  ASSERT_FALSE(canceled);
  EXPECT_EQ(canceled.error().code, base::ErrorCode::kCancelled);
}

}  // namespace
}  // namespace tactus::planning
