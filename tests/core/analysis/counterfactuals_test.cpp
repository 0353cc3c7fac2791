#include "core/analysis/counterfactuals.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "tests/core/analysis/ngt_numbers.h"
#include "tests/support/ngt_model.h"

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

}  // namespace
}  // namespace tactus::analysis
