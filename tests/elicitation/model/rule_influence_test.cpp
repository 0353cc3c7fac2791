#include <gtest/gtest.h>

#include "elicitation/model/record_influence.h"

#include "tests/elicitation/small_study.h"

namespace tactus::elicitation {
namespace {

/// Rounding of another order of summation: 1e-12 of a universe of about 1 N, with room.
constexpr double kInfluenceRounding = 1e-11;

void expectOneByOne(const BuiltModel& built, const std::vector<std::optional<std::size_t>>& rules) {
  const auto found = withoutRules(built, rules);
  ASSERT_EQ(found.size(), rules.size());
  for (std::size_t e = 0; e < rules.size(); ++e) {
    ASSERT_EQ(found[e].has_value(), rules[e].has_value()) << e;
    if (!rules[e]) continue;
    const auto wanted = withoutRule(built, e, *rules[e]);
    ASSERT_TRUE(wanted) << wanted.error().message();
    EXPECT_NEAR(found[e]->difference.largest_n, wanted->difference.largest_n, kInfluenceRounding) << e;
    EXPECT_NEAR(found[e]->difference.rms_n, wanted->difference.rms_n, kInfluenceRounding) << e;
    // The largest change may be the same at two points.
    if (found[e]->difference.at == wanted->difference.at) {
      EXPECT_NEAR(found[e]->noticeable, wanted->noticeable, 1e-9) << e;
    }
    EXPECT_EQ(found[e]->difference.points, wanted->difference.points) << e;
    EXPECT_EQ(found[e]->difference.only_one_fires, wanted->difference.only_one_fires) << e;
  }
}

TEST(RuleInfluence, ForAllExpertsAtOnceItIsThatOfOneAfterAnother) {
  for (const std::uint64_t seed : {3U, 11U, 29U}) {
    const study::Study data = randomStudy(seed);
    BuildSettings settings;
    settings.weights.policy = WeightPolicy::kYears;
    const auto built = buildModel(data, std::vector{form45()}, settings);
    ASSERT_TRUE(built) << built.error().message();
    for (const std::size_t rule : {0U, 2U, 5U}) {
      std::vector<std::optional<std::size_t>> rules;
      for (const auto& expert : built->model.experts) {
        rules.push_back(rule < expert.rules.size() ? std::optional<std::size_t>(rule) : std::nullopt);
      }
      expectOneByOne(*built, rules);
    }
  }
}

// Where one of two experts has a single rule, the other one's force is all that is left without it.
TEST(RuleInfluence, WithoutItsOnlyRuleAnExpertAbstains) {
  study::Study data;
  answerAll(data, "A", "small");
  answerAll(data, "B", "large");
  std::erase_if(data.answers, [](const study::Answer& one) { return one.participant == "B" && one.item > 1; });
  const auto built = buildModel(data, std::vector{form45()}, {});
  ASSERT_TRUE(built) << built.error().message();
  ASSERT_EQ(built->model.experts[1].rules.size(), 1U);
  expectOneByOne(*built, {std::nullopt, 0});
  // Without the only rule of the only expert there is no force to compare.
  study::Study single;
  answerAll(single, "A", "small");
  single.answers.resize(1);
  const auto one = buildModel(single, std::vector{form45()}, {});
  ASSERT_TRUE(one) << one.error().message();
  expectOneByOne(*one, {0});
}

// A rule that is switched off moves nothing at all, not even by rounding.
TEST(RuleInfluence, ADisabledRuleMovesNothing) {
  study::Study data;
  answerAll(data, "A", "small");
  answerAll(data, "B", "small");
  auto built = buildModel(data, std::vector{form45()}, {});
  ASSERT_TRUE(built) << built.error().message();
  built->model.experts[1].rules[4].enabled = false;
  const std::vector<std::optional<std::size_t>> rules = {std::nullopt, 4};
  EXPECT_EQ(withoutRules(*built, rules)[1]->difference.largest_n, 0);
}

TEST(RuleInfluence, EndsAfterARequestToStop) {
  const study::Study data = randomStudy(3);
  const auto built = buildModel(data, std::vector{form45()}, {});
  ASSERT_TRUE(built);
  std::stop_source source;
  source.request_stop();
  const std::vector<std::optional<std::size_t>> rules(built->model.experts.size(), 0);
  for (const auto& one : withoutRules(*built, rules, source.get_token())) EXPECT_FALSE(one);
}

}  // namespace
}  // namespace tactus::elicitation
