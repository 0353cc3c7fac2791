#include "core/analysis/expert_spread.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "tests/support/ngt_model.h"

namespace tactus::analysis {
namespace {

using fuzzy::ForceModel;

/// Experts who say one word each, whatever the inputs: small .35 N, medium .55 N, large .7 N, each symmetric.
ForceModel saying(const std::vector<const char*>& words) {
  ForceModel model = support::ngtVariables();
  int number = 0;
  for (const char* word : words) {
    fuzzy::Expert expert;
    expert.id = "E" + std::to_string(++number);
    for (const auto& term : model.inputs[2].terms) {
      expert.rules.push_back({{{"depth", term.id}}, word, 1, true});
    }
    model.experts.push_back(std::move(expert));
  }
  return model;
}

double tenth(double /*force*/) { return 0.1; }

std::vector<ExpertSpread> apart(const ForceModel& model, std::optional<std::size_t> regions, double times = 2) {
  const auto compiled = fuzzy::compile(model).value();
  ForceProbe probe(model, compiled, 100'000'000);
  return expertsApart(probe, regions, tenth, times, 5000);
}

TEST(ExpertSpread, OfTwoExperts) {
  const auto found = apart(saying({"large", "small"}), std::nullopt);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].region, "");
  EXPECT_EQ(found[0].low, 1U);
  EXPECT_EQ(found[0].high, 0U);
  EXPECT_NEAR(found[0].high_n - found[0].low_n, 0.35, 1e-12);
  EXPECT_NEAR(found[0].mean_n, 0.525, 1e-12);
  EXPECT_TRUE(found[0].mean_far_from_all) << ".175 N from either, .1 N is felt";
  // .35 N is below four noticeable differences.
  EXPECT_TRUE(apart(saying({"large", "small"}), std::nullopt, 4).empty());
}

TEST(ExpertSpread, SomebodyInTheMiddleFeelsTheMean) {
  const auto found = apart(saying({"large", "small", "medium"}), std::nullopt);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].mean_n, 1.6 / 3, 1e-12);
  EXPECT_EQ(found[0].nearest, 2U);
  EXPECT_FALSE(found[0].mean_far_from_all);
}

TEST(ExpertSpread, OneEntryForEachRegion) {
  ForceModel model = saying({"large", "small"});
  model.experts[1].rules[1].then = "large";  // they agree about the nasopharynx
  const auto found = apart(model, 2);
  std::vector<std::string> regions;
  for (const auto& one : found) {
    regions.push_back(one.region);
    ASSERT_EQ(one.point.size(), 4U);
  }
  // At the border of the nasopharynx the neighbor's rule still pulls, so it may be listed too; the others must be.
  for (const char* region : {"nasal_cavity", "oropharynx", "laryngopharynx", "esophagus", "stomach"}) {
    EXPECT_NE(std::find(regions.begin(), regions.end(), region), regions.end()) << region;
  }
}

TEST(ExpertSpread, ExpertsThatDoNotCountAreNotCompared) {
  ForceModel model = saying({"large", "small"});
  model.experts[1].weight = 0;
  EXPECT_TRUE(apart(model, std::nullopt).empty());
  model = saying({"large", "small"});
  model.experts[1].rules.resize(1);  // knows the nasal cavity alone
  const auto found = apart(model, 2);
  for (const auto& one : found) EXPECT_LE(one.point[2], 80) << "elsewhere one of them abstains";
}

}  // namespace
}  // namespace tactus::analysis
