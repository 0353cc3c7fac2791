
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <utility>

#include "core/analysis/force_balance.h"
#include "core/base/random.h"

#include "tests/core/analysis/ngt_numbers.h"
#include "tests/support/invented_experts.h"
#include "tests/support/ngt_model.h"
#include "tests/support/random_model.h"

namespace tactus::analysis {
namespace {

using CounterfactualKind = Counterfactual::Kind;
// sqrt(.04^2 + (.12 F)^2), the specification's just-noticeable difference.
class Counterfactuals : public testing::Test {
 protected:
  void at(const std::vector<double>& point) {
    const auto model = support::s4FiveRegions();
    const auto compiled = fuzzy::compile(model);
    ASSERT_TRUE(compiled.has_value());
    now_n_ = compiled->evaluate(point).force_n;
    auto found = counterfactuals(model, *compiled, point, noticeable);
    ASSERT_TRUE(found.has_value());
    found_ = *found;
  }

  const Counterfactual* find(CounterfactualKind kind, std::size_t input, const std::string& term = {}) const {
    const auto it = std::find_if(found_.begin(), found_.end(), [&](const auto& one) {
      return one.kind == kind && one.input == input && (kind != CounterfactualKind::kTerm || one.term == term);
    });
    return it == found_.end() ? nullptr : &*it;
  }

  /// The change of the force with `input` in the middle of `term`.
  double change(std::size_t input, const std::string& term) const {
    const auto* const found = find(CounterfactualKind::kTerm, input, term);
    return found != nullptr ? found->force_n - now_n_ : std::nan("");
  }

  std::vector<Counterfactual> found_;
  double now_n_ = 0;
};

// As in force_balance_test.cpp: numbers of another program, to the digits it printed.
TEST_F(Counterfactuals, InTheEsophagusWithTheNeckFlexed) {
  at({1, 60, 200, 50});
  EXPECT_NEAR(change(kLubrication, "poor"), .071252, 5e-7);
  EXPECT_NEAR(change(kLubrication, "medium"), .008712, 5e-7);
  EXPECT_EQ(find(CounterfactualKind::kTerm, kLubrication, "well"), nullptr) << "it is well lubricated";
  EXPECT_NEAR(change(kFlexion, "small"), -.139444, 5e-7);
  EXPECT_NEAR(change(kFlexion, "medium"), -.139444, 5e-7);
  EXPECT_NEAR(change(kFlexion, "large"), .072937, 5e-7);
  EXPECT_NEAR(change(kSpeed, "medium"), .008712, 5e-7);
  EXPECT_NEAR(change(kSpeed, "fast"), .071252, 5e-7);

  EXPECT_NEAR(find(CounterfactualKind::kNoticeable, kFlexion)->value, 56.6623, 5e-5);
  EXPECT_NEAR(find(CounterfactualKind::kNoticeable, kFlexion)->delta, -3.3377, 5e-5);
  EXPECT_NEAR(find(CounterfactualKind::kNoticeable, kDepth)->value, 188.2822, 5e-5);
  EXPECT_EQ(find(CounterfactualKind::kNoticeable, kLubrication), nullptr);
  EXPECT_EQ(find(CounterfactualKind::kNoticeable, kSpeed), nullptr);
  EXPECT_NEAR(std::abs(find(CounterfactualKind::kNoticeable, kFlexion)->force_n - now_n_), noticeable(now_n_), 1e-9);

  const auto* const word = find(CounterfactualKind::kLargestWord, kFlexion);
  ASSERT_NE(word, nullptr);
  EXPECT_NEAR(word->value, 61.7423, 5e-5);
  EXPECT_EQ(word->term, "small");
  EXPECT_EQ(word->instead, "very_large");
}

TEST_F(Counterfactuals, BetweenNoseAndNasopharynx) {
  at({1, 60, 70, 50});
  EXPECT_NEAR(change(kLubrication, "poor"), .243925, 5e-7);
  EXPECT_NEAR(change(kFlexion, "large"), 0, 5e-7);
  EXPECT_NEAR(change(kSpeed, "medium"), .049980, 5e-7);
  EXPECT_NEAR(change(kSpeed, "fast"), .205203, 5e-7);
  EXPECT_NEAR(find(CounterfactualKind::kNoticeable, kDepth)->value, 66.5005, 5e-5);
  EXPECT_NEAR(find(CounterfactualKind::kNoticeable, kLubrication)->value, .381123, 5e-7);
  EXPECT_NEAR(find(CounterfactualKind::kNoticeable, kSpeed)->value, 120.6943, 5e-5);
  const auto* const word = find(CounterfactualKind::kLargestWord, kDepth);
  ASSERT_NE(word, nullptr);
  EXPECT_NEAR(word->value, 70.5051, 5e-5);
  EXPECT_EQ(word->instead, "medium");
}

TEST_F(Counterfactuals, TwoWordsThatTie) {
  at({.3, 45, 170, 80});
  EXPECT_NEAR(change(kLubrication, "poor"), .139456, 5e-7);
  EXPECT_NEAR(change(kLubrication, "medium"), -.165942, 5e-7);
  EXPECT_NEAR(change(kSpeed, "slow"), -.002213, 5e-7);
  EXPECT_NEAR(find(CounterfactualKind::kNoticeable, kLubrication)->value, .354653, 5e-7);
  std::vector<const Counterfactual*> ties;
  for (const auto& one : found_) {
    if (one.kind == CounterfactualKind::kLargestWord) ties.push_back(&one);
  }
  ASSERT_EQ(ties.size(), 1U);
  EXPECT_EQ(ties[0]->delta, 0);
  EXPECT_EQ(ties[0]->term, "medium");
  EXPECT_EQ(ties[0]->instead, "very_large");
}

TEST_F(Counterfactuals, WithoutAForceThereAreNone) {
  auto model = support::s4FiveRegions();
  model.experts[0].rules = {{{{"speed", "fast"}}, "large"}};
  const auto compiled = fuzzy::compile(model);
  const auto found = counterfactuals(model, *compiled, std::vector<double>{1, 60, 200, 20}, noticeable);
  ASSERT_TRUE(found.has_value());
  EXPECT_TRUE(found->empty());
}

/// One input from 0 to 10 with the terms low and high, which say small and large.
fuzzy::ForceModel lowAndHigh(std::vector<double> low, std::vector<double> high) {
  fuzzy::ForceModel model;
  model.name = "low and high";
  model.inputs = {{"x", "X", "1", 0, 10, {}}};
  model.inputs[0].terms = {{"low", "Low", fuzzy::Shape::kTrapezoid, std::move(low)},
                           {"high", "High", fuzzy::Shape::kTrapezoid, std::move(high)}};
  model.output = {"force", "Force", "N", 0, 1, {}};
  model.output.terms = {{"small", "Small", fuzzy::Shape::kTriangle, {0, .2, .4}},
                        {"large", "Large", fuzzy::Shape::kTriangle, {.6, .8, 1}}};
  model.experts.push_back({"one", "One", 1, {}, {{{{"x", "low"}}, "small"}, {{{"x", "high"}}, "large"}}});
  return model;
}

std::vector<Counterfactual> movesOf(const fuzzy::ForceModel& model, double x) {
  const auto compiled = fuzzy::compile(model);
  EXPECT_TRUE(compiled.has_value());
  auto found = counterfactuals(model, *compiled, std::vector<double>{x}, noticeable);
  std::erase_if(*found, [](const auto& one) { return one.kind == CounterfactualKind::kTerm; });
  return *found;
}

// Both terms are 0 at 5 and at no other place: nobody can stop there.
TEST_F(Counterfactuals, AHoleOfOnePointIsPassed) {
  const auto found = movesOf(lowAndHigh({0, 0, 4, 5}, {5, 6, 10, 10}), 2);
  ASSERT_EQ(found.size(), 2U);
  for (const auto& one : found) {
    EXPECT_GT(one.value, 5);
    EXPECT_NEAR(one.value, 5, 1e-8);
    EXPECT_NEAR(one.force_n, .8, 1e-9);
  }
  EXPECT_EQ(found[1].instead, "large");
}

TEST_F(Counterfactuals, AHoleWithAWidthEndsTheSearch) {
  EXPECT_TRUE(movesOf(lowAndHigh({0, 0, 4, 5}, {5.001, 6, 10, 10}), 2).empty());
}

struct Scan {
  double largest_n = 0;  ///< change of the force
  double distance = 0;   ///< the nearest at which it is that large
};

/// The largest change of the force along `input` before a hole, from even looks.
Scan scanned(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled, std::vector<double> point,
             std::size_t input, int looks) {
  const double now = point[input];
  const double now_n = compiled.evaluate(point).force_n;
  Scan out;
  for (const double end : {model.inputs[input].min, model.inputs[input].max}) {
    for (int look = 1; look < looks; ++look) {
      point[input] = now + (end - now) * look / looks;
      const auto there = compiled.evaluate(point);
      if (!there.fired) break;
      const double change_n = std::abs(there.force_n - now_n);
      const double distance = std::abs(point[input] - now);
      if (change_n > out.largest_n || (change_n == out.largest_n && distance < out.distance))
        out = {change_n, distance};
    }
  }
  return out;
}

// What is felt is set to the largest change that 10,000 looks find: only its peak reaches it, wherever that lies.
TEST_F(Counterfactuals, NoPeakIsTooNarrow) {
  base::Random random(5);
  int searched = 0;
  for (int i = 0; i < 150; ++i) {
    const auto model = support::randomModel(random, {.gaussians = i % 3 == 0, .adversarial = false});
    const auto compiled = fuzzy::compile(model);
    std::vector<double> point;
    for (const auto& input : model.inputs) point.push_back(random.uniform(input.min, input.max));
    if (!compiled->evaluate(point).fired) continue;
    const std::size_t input = static_cast<std::size_t>(i) % model.inputs.size();
    const double range_n = model.output.max - model.output.min;
    const double range = model.inputs[input].max - model.inputs[input].min;
    const Scan scan = scanned(model, *compiled, point, input, 5000);
    if (scan.largest_n < 1e-3 * range_n) continue;
    ++searched;
    const auto found =
        counterfactuals(model, *compiled, point, [&](double /*force_n*/) { return scan.largest_n * (1 - 1e-9); });
    const auto move = std::find_if(found->begin(), found->end(), [&](const auto& one) {
      return one.kind == CounterfactualKind::kNoticeable && one.input == input;
    });
    ASSERT_NE(move, found->end()) << "model " << i;
    EXPECT_GE(std::abs(move->force_n - compiled->evaluate(point).force_n), scan.largest_n * (1 - 1e-8)) << i;
    EXPECT_LE(std::abs(move->delta), scan.distance + 1e-9 * range) << i;
  }
  EXPECT_GT(searched, 80);
}

// Edges a few ulps apart, tiny strengths, universes far from 0: the moves are still what they say.
TEST_F(Counterfactuals, OfAdversarialModelsAreTrue) {
  base::Random random(8);
  int felt = 0;
  for (int i = 0; i < 300; ++i) {
    const auto model = support::randomModel(random, {.gaussians = i % 2 == 1});
    const auto point = support::randomPoint(random, model);
    const auto compiled = fuzzy::compile(model);
    const auto now = compiled->evaluate(point);
    const double felt_n = .05 * (model.output.max - model.output.min);
    const auto found = counterfactuals(model, *compiled, point, [&](double /*force_n*/) { return felt_n; });
    ASSERT_TRUE(found.has_value());
    for (const auto& one : *found) {
      auto there = point;
      there[one.input] = one.value;
      EXPECT_EQ(compiled->evaluate(there).force_n, one.force_n) << i;
      if (one.kind != CounterfactualKind::kNoticeable) continue;
      ++felt;
      EXPECT_GE(std::abs(one.force_n - now.force_n), felt_n) << i;
    }
  }
  EXPECT_GT(felt, 50);
}

// The word with the largest share at 1,000 looks, from ForceBalance.
TEST_F(Counterfactuals, NoOtherWordIsTheLargestBefore) {
  base::Random random(6);
  int searched = 0;
  for (int i = 0; i < 24; ++i) {
    auto model = support::inventedExperts();
    if (i % 4 == 3) {
      for (auto& term : model.output.terms) {
        term = {term.id, term.label, fuzzy::Shape::kGaussian, {(term.points.front() + term.points.back()) / 2, .09}};
      }
    }
    const auto compiled = fuzzy::compile(model);
    std::vector<double> point;
    for (const auto& input : model.inputs) point.push_back(random.uniform(input.min, input.max));
    const std::size_t input = i % 2 == 0 ? kDepth : kSpeed;
    const auto largest = [&](double x) {
      std::vector<double> there = point;
      there[input] = x;
      const ForceBalance balance = forceBalance(model, *explain(model, *compiled, there));
      const auto most = std::max_element(balance.words.begin(), balance.words.end(),
                                         [](const auto& a, const auto& b) { return a.share < b.share; });
      return most->term;
    };
    const double now = point[input];
    const std::string word = largest(now);
    double nearest = std::numeric_limits<double>::infinity();
    constexpr int kLooks = 500;
    for (const double end : {model.inputs[input].min, model.inputs[input].max}) {
      for (int look = 1; look < kLooks; ++look) {
        const double x = now + (end - now) * look / kLooks;
        if (largest(x) == word) continue;
        nearest = std::min(nearest, std::abs(x - now));
        break;
      }
    }
    const auto found = counterfactuals(model, *compiled, point, noticeable);
    const auto move = std::find_if(found->begin(), found->end(), [&](const auto& one) {
      return one.kind == CounterfactualKind::kLargestWord && one.input == input;
    });
    if (std::isinf(nearest)) continue;
    ++searched;
    ASSERT_NE(move, found->end()) << i;
    EXPECT_EQ(move->term, word);
    EXPECT_LE(std::abs(move->delta), nearest) << i;
    // Up to there nothing changes, there and just beyond it does.
    EXPECT_EQ(largest(now + move->delta * (1 - 1e-6)), word) << i;
    EXPECT_NE(largest(now + move->delta * (1 + 1e-6)), word) << i;
  }
  EXPECT_GT(searched, 15);
}

}  // namespace
}  // namespace tactus::analysis
