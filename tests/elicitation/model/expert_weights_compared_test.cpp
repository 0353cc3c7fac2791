#include "elicitation/model/expert_weights_compared.h"

#include <gtest/gtest.h>

#include "core/fuzzy/compiled_model.h"

#include "tests/elicitation/small_study.h"

namespace tactus::elicitation {
namespace {

/// A says small (.35 N, symmetric), B large (.7 N) everywhere; 1 and 3 years, no categories.
study::Study studyOfTwo() {
  study::Study study;
  answerAll(study, "A", "small");
  answerAll(study, "B", "large");
  study.participants[0].years_experience = 1;
  study.participants[1].years_experience = 3;
  study.participants[0].weight = 1;
  study.participants[1].weight = 0;
  return study;
}

fuzzy::ForceModel withoutChecks(fuzzy::ForceModel model) {
  model.checks.clear();
  return model;
}

TEST(WeightsCompared, EachPolicyThatTheDataAllow) {
  const auto data = studyOfTwo();
  BuildSettings settings;
  settings.weights.policy = WeightPolicy::kTable;
  settings.weights.table = {{"A", 1e-300}, {"B", 1e300}};
  const auto built = buildModel(data, std::vector{form45()}, settings);
  ASSERT_TRUE(built) << built.error().message();
  const auto compared = compareWeights(*built, data, settings);
  ASSERT_TRUE(compared) << compared.error().message();
  ASSERT_EQ(compared->size(), 5U);
  const auto& [equal, years, category, column, table] =
      std::tie((*compared)[0], (*compared)[1], (*compared)[2], (*compared)[3], (*compared)[4]);
  EXPECT_EQ(equal.policy, WeightPolicy::kEqual);
  EXPECT_EQ(equal.from_equal.largest_n, 0);
  EXPECT_EQ(equal.from_equal.rms_n, 0);
  // The mean is .525 N with equal weights and (.35 + 3 · .7)/4 = .6125 N by years, everywhere.
  EXPECT_NEAR(years.from_equal.largest_n, 0.0875, 1e-12);
  EXPECT_NEAR(years.from_equal.rms_n, 0.0875, 1e-12);
  EXPECT_NEAR(years.from_equal.first_n, 0.525, 1e-12);
  EXPECT_NEAR(years.from_equal.second_n, 0.6125, 1e-12);
  EXPECT_GT(years.from_equal.points, 10000U);
  EXPECT_EQ(years.from_equal.only_one_fires, 0U);
  EXPECT_FALSE(years.region.empty());
  EXPECT_FALSE(category.model);
  EXPECT_NE(category.unavailable.find("participant A: found no category"), std::string::npos) << category.unavailable;
  EXPECT_NEAR(column.from_equal.second_n, 0.35, 1e-12) << "weight 0 is no weight";
  EXPECT_NEAR(table.from_equal.second_n, 0.7, 1e-12);
}

TEST(WeightsCompared, ReweightingIsBuildingWithTheseWeights) {
  const auto data = randomStudy(7);
  BuildSettings settings;
  const auto built = buildModel(data, std::vector{form45()}, settings);
  settings.weights.policy = WeightPolicy::kYears;
  const auto wanted = buildModel(data, std::vector{form45()}, settings);
  EXPECT_EQ(reweightedModel(*built, data, settings).value(), withoutChecks(wanted->model));
}

TEST(WeightsCompared, RampsThatAreAWeightedMeanAreAveragedAnew) {
  auto data = studyOfTwo();
  const char* levels[] = {"slow", "medium", "fast"};
  for (int sample = 0; sample < 10; ++sample) {
    for (int level = 0; level < 3; ++level) {
      data.speeds.push_back({"A", levels[level], 1, 0.001 * sample, 0, 20.0 + 80 * level});
      data.speeds.push_back({"B", levels[level], 1, 0.001 * sample, 0, 40.0 + 100 * level});
    }
  }
  BuildSettings settings;
  settings.speed.alpha = 1;
  settings.averaging = Averaging::kWeightedMean;
  const auto built = buildModel(data, std::vector{form45()}, settings);
  ASSERT_TRUE(built) << built.error().message();
  settings.weights.policy = WeightPolicy::kYears;
  const auto wanted = buildModel(data, std::vector{form45()}, settings);
  ASSERT_NE(built->model.inputs, wanted->model.inputs);
  EXPECT_EQ(reweightedModel(*built, data, settings).value(), withoutChecks(wanted->model));
}

TEST(WeightsCompared, WhereOnlyOneModelFiresNothingIsCompared) {
  auto data = studyOfTwo();
  // A alone knows the esophagus, and the column gives A no weight.
  data.participants[0].weight = 0;
  data.participants[1].weight = 1;
  std::erase_if(data.answers, [](const auto& answer) { return answer.participant == "B" && answer.item % 5 == 0; });
  const BuildSettings settings;
  const auto built = buildModel(data, std::vector{form45()}, settings);
  const auto compared = compareWeights(*built, data, settings);
  ASSERT_TRUE(compared);
  const auto& column = compared->at(3);
  ASSERT_TRUE(column.model) << column.unavailable;
  EXPECT_GT(column.from_equal.only_one_fires, 0U);
  EXPECT_NEAR(column.from_equal.largest_n, 0.175, 1e-12);
}

}  // namespace
}  // namespace tactus::elicitation
