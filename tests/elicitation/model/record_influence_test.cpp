#include "elicitation/model/record_influence.h"

#include <gtest/gtest.h>

#include "core/fuzzy/compiled_model.h"

#include "tests/elicitation/small_study.h"

namespace tactus::elicitation {
namespace {

/// The difference to a model that is built from `data`.
analysis::ForceDifference toBuild(const fuzzy::ForceModel& model, const study::Study& data,
                                  const BuildSettings& settings) {
  const auto other = buildModel(data, std::vector{form45()}, settings);
  EXPECT_TRUE(other) << other.error().message();
  return analysis::forceDifference(model, *fuzzy::compile(model), other->model, *fuzzy::compile(other->model));
}

/// The judgements of the split of Table 2 (elicitation.md 3), and what A and B answered.
study::Study table2() {
  study::Study study;
  answerAll(study, "A", "small");
  answerAll(study, "B", "large");
  const char* const said[4][11] = {{"small", "medium", "large", "very_large", "very_large", "very_large", "very_large",
                                    "very_large", "very_large", "very_large", "very_large"},
                                   {"very_small", "small", "medium", "medium", "large", "large", "large", "very_large",
                                    "very_large", "very_large", "very_large"},
                                   {"very_small", "very_small", "small", "small", "medium", "medium", "large", "large",
                                    "large", "very_large", "very_large"},
                                   {"very_small", "very_small", "very_small", "small", "medium", "medium", "medium",
                                    "medium", "large", "large", "very_large"}};
  const char* const people[] = {"A", "B", "C", "D"};
  for (const char* more : {"C", "D"}) {
    study.participants.emplace_back();
    study.participants.back().code = more;
  }
  for (int who = 0; who < 4; ++who) {
    for (int step = 0; step < 11; ++step) {
      study::ForceJudgement one;
      one.participant = people[who];
      one.series = "ascending";
      one.step = step + 1;
      one.force_n = 0.1 * (step + 1);
      one.kind = study::ForceJudgement::Kind::kTerm;
      one.term = said[who][step];
      study.judgements.push_back(one);
    }
  }
  return study;
}

TEST(RecordInfluence, WithoutAJudgementTheModelIsThatOfAStudyWithoutIt) {
  const study::Study data = table2();
  for (const auto from :
       {ForceTermsFrom::kVote, ForceTermsFrom::kFrequency, ForceTermsFrom::kThresholds, ForceTermsFrom::kProbit}) {
    BuildSettings settings;
    settings.force_terms = from;
    const auto built = buildModel(data, std::vector{form45()}, settings);
    ASSERT_TRUE(built) << built.error().message();
    double moved = 0;
    for (const std::size_t index : {3U, 14U, 22U, 36U}) {
      study::Study less = data;
      less.judgements.erase(less.judgements.begin() + static_cast<std::ptrdiff_t>(index));
      const auto wanted = toBuild(built->model, less, settings);
      const auto found = withoutJudgement(*built, data, settings, index);
      ASSERT_TRUE(found) << found.error().message();
      EXPECT_EQ(found->difference.largest_n, wanted.largest_n) << name(from) << " " << index;
      EXPECT_EQ(found->difference.rms_n, wanted.rms_n) << name(from) << " " << index;
      moved = std::max(moved, wanted.largest_n);
    }
    EXPECT_GT(moved, 0) << name(from);
  }
}

TEST(RecordInfluence, AVoteThatDecidesNothingMovesNothing) {
  const study::Study data = table2();
  const auto built = buildModel(data, std::vector{form45()}, {});
  ASSERT_TRUE(built);
  // At 1.1 N all four say very large.
  const auto last = withoutJudgement(*built, data, {}, 10);
  ASSERT_TRUE(last) << last.error().message();
  EXPECT_EQ(last->difference.largest_n, 0);
  EXPECT_EQ(last->noticeable, 0);
  // One of the two votes for small at .4 N: then no word has half, and medium is next. A's small was .2 .3 .4 .5 with
  // its middle at .35 N, and becomes .2 .3 .3 .4 with .3 N; the mean of A and B moves by half of that.
  const auto decides = withoutJudgement(*built, data, {}, 25);
  ASSERT_TRUE(decides) << decides.error().message();
  EXPECT_NEAR(decides->difference.largest_n, 0.025, 1e-12);
  // The just-noticeable difference around (.35 + .7) / 2 N: sqrt(.04^2 + (.12 .525)^2) = .074625 N.
  EXPECT_NEAR(decides->noticeable, 0.025 / 0.0746255, 1e-5);
  auto other = data;
  other.judgements[25].series = "random";
  EXPECT_EQ(withoutJudgement(*built, other, {}, 25)->difference.largest_n, 0);
}

TEST(RecordInfluence, WithoutARuleTheModelIsThatOfAStudyWithoutTheAnswer) {
  study::Study data = randomStudy(11);
  const auto built = buildModel(data, std::vector{form45()}, {});
  ASSERT_TRUE(built) << built.error().message();
  for (const std::size_t rule : {0U, 7U, 16U}) {
    const ExpertRules& expert = built->experts.front();
    ASSERT_LT(rule, expert.origins.size());
    study::Study less = data;
    std::erase_if(less.answers, [&](const study::Answer& answer) {
      return answer.participant == expert.participant.code && answer.item == expert.origins[rule].item;
    });
    ASSERT_EQ(less.answers.size() + 1, data.answers.size());
    const auto wanted = toBuild(built->model, less, {});
    const auto found = withoutRule(*built, 0, rule);
    ASSERT_TRUE(found) << found.error().message();
    EXPECT_EQ(found->difference.largest_n, wanted.largest_n) << rule;
    EXPECT_EQ(found->difference.at, wanted.at) << rule;
  }
}

}  // namespace
}  // namespace tactus::elicitation
