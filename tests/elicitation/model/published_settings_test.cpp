// Settings unlike the published ones, and the newtons by which they move the force.
#include "elicitation/model/published_settings.h"

#include <gtest/gtest.h>

#include "elicitation/model/model_provenance.h"

#include "tests/elicitation/model/small_study.h"

namespace tactus::elicitation {
namespace {

using Names = std::vector<std::string>;

/// A says Small and B Medium wherever the tube is well, medium or poorly lubricated: .35 and .55 N.
study::Study smallAndMedium() {
  study::Study study;
  study.participants = {participant("A", 3), participant("B", 1)};
  for (const auto& [code, then] : {std::pair("A", "small"), std::pair("B", "medium")}) {
    for (const char* term : {"poor", "medium", "well"}) {
      study::GivenRule rule;
      rule.participant = code;
      rule.conditions = {{"lubrication", term}};
      rule.then = then;
      study.rules.push_back(rule);
    }
  }
  return study;
}

fuzzy::Provenance originOf(const BuildSettings& settings) {
  const study::Study study = smallAndMedium();
  auto built = buildModel(study, forms(), settings);
  EXPECT_TRUE(built.has_value()) << built.error().message();
  noteUnlikePublished(*built, study, forms(), settings);
  return *built->model.provenance;
}

TEST(PublishedSettings, TheDefaultsAreThePapers) {
  const auto origin = originOf({});
  EXPECT_EQ(settingsUnlikePublished(origin), Names{});
  EXPECT_EQ(newtonsUnlikePublished(origin), std::nullopt);
  EXPECT_EQ(settingsUnlikePublished({}), Names{}) << "a file of another program";
}

TEST(PublishedSettings, WeightsByYearsMoveThisForceByATwentiethOfANewton) {
  BuildSettings settings;
  settings.weights.policy = WeightPolicy::kYears;
  const auto origin = originOf(settings);
  EXPECT_EQ(settingsUnlikePublished(origin), Names{"weights"});
  // (3 * .35 + .55) / 4 instead of (.35 + .55) / 2.
  ASSERT_TRUE(newtonsUnlikePublished(origin).has_value());
  EXPECT_NEAR(*newtonsUnlikePublished(origin), 0.05, 1e-12);
}

TEST(PublishedSettings, EachSettingIsNamed) {
  BuildSettings settings;
  settings.speed.alpha = 0.8;
  settings.speed.fcm.m = 1.5;
  settings.averaging = Averaging::kMedian;
  EXPECT_EQ(settingsUnlikePublished(originOf(settings)), (Names{"alpha", "m", "averaging"}));
  EXPECT_EQ(newtonsUnlikePublished({"", {{"unlike_published", "{ \"settings\": [\"alpha\"] }"}}, {}, ""}), std::nullopt)
      << "no model could be built with the published ones";
}

}  // namespace
}  // namespace tactus::elicitation
