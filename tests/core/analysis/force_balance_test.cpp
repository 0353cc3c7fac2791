#include "core/analysis/force_balance.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "core/base/random.h"

#include "tests/support/invented_experts.h"
#include "tests/support/ngt_model.h"
#include "tests/support/random_model.h"

namespace tactus::analysis {
namespace {

ForceBalance balanceAt(const fuzzy::ForceModel& model, const std::vector<double>& point,
                       std::optional<std::size_t> expert = std::nullopt) {
  const auto compiled = fuzzy::compile(model);
  EXPECT_TRUE(compiled.has_value());
  const auto explanation = explain(model, *compiled, point);
  EXPECT_TRUE(explanation.has_value());
  return forceBalance(model, *explanation, expert);
}

struct Word {
  const char* term;
  double strength, share, centroid_n, pull_n;
};

void expectWords(const ForceBalance& balance, const std::vector<Word>& words) {
  ASSERT_EQ(balance.words.size(), words.size());
  for (std::size_t w = 0; w < words.size(); ++w) {
    EXPECT_EQ(balance.words[w].term, words[w].term);
    EXPECT_NEAR(balance.words[w].strength, words[w].strength, 5e-5) << words[w].term;
    EXPECT_NEAR(balance.words[w].share, words[w].share, 5e-5) << words[w].term;
    EXPECT_NEAR(balance.words[w].centroid_n, words[w].centroid_n, 5e-5) << words[w].term;
    EXPECT_NEAR(balance.words[w].pull_n, words[w].pull_n, 5e-7) << words[w].term;
  }
}

// The numbers that another program computed for S4's five regions, to the digits it printed.
TEST(ForceBalance, TheWordsOfS4AtThreePoints) {
  const auto s4 = support::s4FiveRegions();
  const auto a = balanceAt(s4, {1, 60, 200, 50});
  EXPECT_NEAR(a.force_n, .589444, 5e-7);
  expectWords(a, {{"small", .5, .3429, .3370, -.086540},
                  {"medium", .5, .3333, .5595, -.009974},
                  {"large", .25, .0762, .7250, .010328},
                  {"very_large", .25, .2476, .9375, .086185}});
  expectWords(balanceAt(s4, {1, 60, 70, 50}), {{"very_small", .5, .3704, .1250, -.078761},
                                               {"small", .5, .2963, .35, .003658},
                                               {"medium", .5, .3333, .5630, .075103}});
  expectWords(balanceAt(s4, {.3, 45, 170, 80}), {{"small", .5, .2218, .3370, -.068384},
                                                 {"medium", 1, .3502, .5515, -.032866},
                                                 {"large", .4444, .0779, .70, .004254},
                                                 {"very_large", .5, .3502, .9224, .096996}});
}

// Rules 23 and 33 say medium with strengths 1 and 5/9: 5/9 is shared, the rest is rule 23's alone.
TEST(ForceBalance, RulesShareTheirWordByTheMaxGame) {
  const auto balance = balanceAt(support::s4FiveRegions(), {.3, 45, 170, 80});
  const double medium_n = balance.words[1].pull_n;
  for (const RulePull& rule : balance.rules) {
    if (rule.rule == 22) {
      EXPECT_NEAR(rule.pull_n / medium_n, 13. / 18, 1e-9);
    } else if (rule.rule == 32) {
      EXPECT_NEAR(rule.pull_n / medium_n, 5. / 18, 1e-9);
    }
  }
}

TEST(ForceBalance, ExpertsPullTheMean) {
  const auto balance = balanceAt(support::inventedExperts(), {1, 60, 200, 50});
  EXPECT_NEAR(balance.force_n, .534861, 5e-7);
  const double pulls_n[] = {-.021215, .016285, -.008715, .013646};
  const double left_out_n[] = {-.028287, .021713, -.011620, .018194};
  ASSERT_EQ(balance.experts.size(), 4U);
  for (std::size_t e = 0; e < 4; ++e) {
    EXPECT_NEAR(balance.experts[e].pull_n, pulls_n[e], 5e-7);
    EXPECT_NEAR(balance.experts[e].leave_one_out_n.value(), left_out_n[e], 5e-7);
  }
  const auto alone = balanceAt(support::inventedExperts(), {1, 60, 200, 50}, 3);
  EXPECT_NEAR(alone.force_n, .589444, 5e-7);
  ASSERT_EQ(alone.experts.size(), 1U);
  EXPECT_FALSE(alone.experts[0].leave_one_out_n.has_value());
}

/// Areas and moments of the slices from `samples` midpoints.
struct Sampled {
  std::vector<double> areas;
  std::vector<double> moments;
  double area = 0;
  double moment = 0;
};

Sampled sampled(const fuzzy::ForceModel& model, const std::vector<double>& strengths, int samples) {
  std::vector<fuzzy::MembershipFunction> functions;
  for (const auto& term : model.output.terms) functions.push_back(fuzzy::MembershipFunction::of(term));
  Sampled out{std::vector<double>(functions.size()), std::vector<double>(functions.size())};
  const double step = (model.output.max - model.output.min) / samples;
  for (int i = 0; i < samples; ++i) {
    const double x = model.output.min + (i + .5) * step;
    std::size_t top = 0;
    double highest = -1;
    for (std::size_t t = 0; t < functions.size(); ++t) {
      const double membership = functions[t](x);
      const bool clip = model.implication == fuzzy::Implication::kClip;
      const double height = clip ? std::min(strengths[t], membership) : strengths[t] * membership;
      if (height > highest) top = t, highest = height;
    }
    out.areas[top] += highest, out.moments[top] += highest * x;
    out.area += highest, out.moment += highest * x;
  }
  return out;
}

// Unlike shapes cross anywhere: two Gaussians of other widths, a Gaussian and a flank, a Gaussian and a plateau.
TEST(ForceBalance, GaussianWordsAgainstAMillionSamples) {
  fuzzy::ForceModel model;
  model.name = "unlike shapes";
  model.inputs = {{"x", "X", "1", 0, 1, {{"all", "All", fuzzy::Shape::kTrapezoid, {0, 0, 1, 1}}}}};
  model.output = {"force", "Force", "N", 0, 1.1, {}};
  model.output.terms = {{"low", "Low", fuzzy::Shape::kGaussian, {.2, .11}},
                        {"middle", "Middle", fuzzy::Shape::kTrapezoid, {.15, .5, .55, .9}},
                        {"high", "High", fuzzy::Shape::kGaussian, {.7, .06}},
                        {"top", "Top", fuzzy::Shape::kGaussian, {1.3, .4}}};
  const std::vector<double> strengths = {.8, .55, .9, .35};
  model.experts.push_back({"one", "One", 1, {}, {}});
  for (std::size_t t = 0; t < strengths.size(); ++t) {
    model.experts[0].rules.push_back({{{"x", "all"}}, model.output.terms[t].id, strengths[t]});
  }
  for (const auto implication : {fuzzy::Implication::kClip, fuzzy::Implication::kScale}) {
    model.implication = implication;
    const auto balance = balanceAt(model, {.5});
    const Sampled reference = sampled(model, strengths, 1000000);
    const double force_n = reference.moment / reference.area;
    EXPECT_NEAR(balance.force_n, force_n, 1e-9);
    ASSERT_EQ(balance.words.size(), strengths.size());
    for (std::size_t t = 0; t < strengths.size(); ++t) {
      const auto& word = balance.words[t];
      // Half a sample at each end of a slice.
      EXPECT_NEAR(word.share, reference.areas[t] / reference.area, 1e-6) << word.term;
      EXPECT_NEAR(word.pull_n, (reference.moments[t] - force_n * reference.areas[t]) / reference.area, 1e-6)
          << word.term;
    }
  }
}

// Whatever the model: shares sum to 1, and all pulls to 0.
TEST(ForceBalance, IsInBalance) {
  base::Random random(11);
  int balanced = 0;
  for (int i = 0; i < 400; ++i) {
    const auto model = support::randomModel(random, {.gaussians = i % 2 == 1});
    std::vector<double> point;
    for (const auto& input : model.inputs) point.push_back(input.min + (input.max - input.min) * random.uniform());
    const auto balance = balanceAt(model, point);
    if (balance.experts.empty()) continue;
    ++balanced;
    const double range = model.output.max - model.output.min;
    double share = 0;
    double words_n = 0;
    double rules_n = 0;
    double experts_n = 0;
    for (const auto& word : balance.words) share += word.share, words_n += word.pull_n;
    for (const auto& rule : balance.rules) rules_n += rule.pull_n;
    for (const auto& expert : balance.experts) experts_n += expert.pull_n;
    EXPECT_NEAR(share, 1, 1e-9);
    EXPECT_NEAR(words_n, 0, 1e-9 * range);
    EXPECT_NEAR(rules_n, words_n, 1e-9 * range);
    EXPECT_NEAR(experts_n, 0, 1e-9 * range);
  }
  EXPECT_GT(balanced, 200);
}

// The area of such sets is below the smallest double: all lies at one place, and nothing pulls.
TEST(ForceBalance, SetsWithoutAnAreaPullNothing) {
  auto model = support::s4FiveRegions();
  for (auto& term : model.output.terms) term = {term.id, term.label, fuzzy::Shape::kTrapezoid, {0, 0, 0, 5e-324}};
  const auto balance = balanceAt(model, {1, 60, 200, 50});
  EXPECT_EQ(balance.force_n, 0);
  EXPECT_EQ(balance.words.size(), 4U);
  for (const auto& word : balance.words) EXPECT_EQ(word.pull_n, 0) << word.term;
}

TEST(ForceBalance, WithoutAForceThereIsNone) {
  auto model = support::s4FiveRegions();
  model.experts[0].rules.clear();
  model.experts[0].rules.push_back({{{"speed", "fast"}}, "large"});
  const auto balance = balanceAt(model, {1, 60, 200, 20});
  EXPECT_TRUE(balance.words.empty());
  EXPECT_TRUE(balance.rules.empty());
  EXPECT_TRUE(balance.experts.empty());
}

}  // namespace
}  // namespace tactus::analysis
