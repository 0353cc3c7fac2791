// The stroke that tells two models apart.
#include "core/contracts/telling_stroke.h"

#include <algorithm>
#include <functional>
#include <gtest/gtest.h>
#include <stop_token>
#include <vector>

#include "core/base/random.h"

#include "tests/support/invented_experts.h"
#include "tests/support/ngt_model.h"
#include "tests/support/two_experts.h"

namespace tactus::contracts {
namespace {

using Change = std::function<void(fuzzy::ForceModel&)>;

fuzzy::ForceModel edited(fuzzy::ForceModel model, const Change& change) {
  change(model);
  return model;
}

TellingStroke told(const fuzzy::ForceModel& first, const fuzzy::ForceModel& second, bool bound = true) {
  const auto found = tell(first, *fuzzy::compile(first), second, *fuzzy::compile(second), {}, {.bound = bound});
  EXPECT_TRUE(found.has_value());
  return found.value_or(TellingStroke{});
}

/// Moves the ramp between two terms.
void moveRamp(fuzzy::Variable& variable, std::size_t left, double by) {
  auto& a = variable.terms[left].points;
  auto& b = variable.terms[left + 1].points;
  a[2] += by, a[3] += by, b[0] += by, b[1] += by;
}

struct ReferenceEdit {
  const char* name;
  Change change;
  double paper_jnd;  ///< along Fig. 11's conditions, 100 to 250 mm, at 50 mm/s in the mean
  double found_jnd;  ///< by another program's search
};

// Reference figures, from another program, to two digits.
std::vector<ReferenceEdit> referenceEdits() {
  return {{"rule 28 to very large", [](auto& m) { m.experts[0].rules[27].then = "very_large"; }, .68, 3.02},
          {"rule 3 to medium", [](auto& m) { m.experts[0].rules[2].then = "medium"; }, .79, 1.61},
          {"laryngopharynx and esophagus 8 mm later", [](auto& m) { moveRamp(m.inputs[2], 2, 8); }, .16, .87},
          {"slow, nasopharynx to small", [](auto& m) { m.experts[0].rules[31].then = "small"; }, .06, 1.07}};
}

TEST(TellingStroke, ReferenceEditsAreFoundAtLeastAsWell) {
  const auto s4 = support::s4FiveRegions();
  for (const ReferenceEdit& edit : referenceEdits()) {
    const auto other = edited(s4, edit.change);
    const Stroke paper{100, 250, 50 * 15.0 / 8, {1, 60, 0, 0}};
    const auto feel = feelOf(*fuzzy::compile(s4), *fuzzy::compile(other), {2, 3}, paper);
    EXPECT_NEAR(feel.rms_jnd, edit.paper_jnd, 0.02) << edit.name;
    const TellingStroke found = told(s4, other);
    EXPECT_GE(found.feel.rms_jnd, edit.found_jnd - 0.005) << edit.name;
    ASSERT_TRUE(found.bound_jnd.has_value());
    EXPECT_GE(*found.bound_jnd, found.feel.largest_jnd) << edit.name;
    EXPECT_GE(found.stroke.to_mm - found.stroke.from_mm, 30 - 1e-9);
    EXPECT_GE(found.stroke.peak_mm_s, 5);
    EXPECT_LE(found.stroke.peak_mm_s, 250);
  }
}

// By hand: minimum jerk is at half of the way after half of the time, where the speed is 15/8 of the mean; after a
// quarter it has made 1/64 (10 - 15/4 + 6/16) = 0.103515625 of the way, at 16 (1/16) (9/16) = 0.5625 of the peak.
TEST(TellingStroke, MomentsAreThoseOfMinimumJerk) {
  const Stroke stroke{100, 250, 187.5, {1, 60, 0, 0}};  // 100 mm/s in the mean: 1.5 s
  const StrokeMoment middle = momentOf(stroke, 0.5);
  EXPECT_DOUBLE_EQ(middle.time_s, 0.75);
  EXPECT_DOUBLE_EQ(middle.depth_mm, 175);
  EXPECT_DOUBLE_EQ(middle.speed_mm_s, 187.5);
  const StrokeMoment quarter = momentOf(stroke, 0.25);
  EXPECT_DOUBLE_EQ(quarter.depth_mm, 100 + 150 * 0.103515625);
  EXPECT_DOUBLE_EQ(quarter.speed_mm_s, 187.5 * 0.5625);
  EXPECT_EQ(momentOf(stroke, 0).depth_mm, 100);
  EXPECT_DOUBLE_EQ(momentOf(stroke, 1).time_s, 1.5);
  EXPECT_DOUBLE_EQ(momentOf(stroke, 1).depth_mm, 250);
  EXPECT_EQ(momentOf(stroke, 1).speed_mm_s, 0);
}

TEST(TellingStroke, SaysHowFarItIs) {
  const auto s4 = support::s4FiveRegions();
  const auto other = edited(s4, [](auto& m) { m.experts[0].rules[2].then = "medium"; });
  std::vector<double> shares;
  TellEffort effort;
  effort.progress = [&](double share) { shares.push_back(share); };
  ASSERT_TRUE(tell(s4, *fuzzy::compile(s4), other, *fuzzy::compile(other), {}, effort));
  ASSERT_GT(shares.size(), 10U);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_GT(shares.front(), 0);
  EXPECT_EQ(shares.back(), 1);
}

TEST(TellingStroke, AWayShorterThanTheShortestStrokeIsMadeWhole) {
  const auto model = tests::twoExperts();  // 10 mm
  const auto other = edited(model, [](auto& m) { m.experts[0].rules[0].then = "high"; });
  const TellingStroke found = told(model, other);
  EXPECT_EQ(found.stroke.from_mm, 0);
  EXPECT_EQ(found.stroke.to_mm, 10);
  EXPECT_GT(found.feel.rms_jnd, 1);
}

TEST(TellingStroke, EqualModelsAreProvedEqual) {
  for (const auto& model : {support::s4FiveRegions(), support::inventedExperts()}) {
    const TellingStroke found = told(model, model);
    EXPECT_EQ(found.feel.rms_jnd, 0);
    ASSERT_TRUE(found.bound_jnd.has_value());
    EXPECT_LE(*found.bound_jnd, 0.02);
  }
}

TEST(TellingStroke, AnEditBelowAnyHandIsProvedSmall) {
  const auto four = support::inventedExperts();
  const auto other = edited(four, [](auto& m) { moveRamp(m.inputs[3], 0, 0.2); });
  const TellingStroke found = told(four, other);
  EXPECT_LT(found.feel.rms_jnd, 0.1);
  ASSERT_TRUE(found.bound_jnd.has_value());
  EXPECT_GE(*found.bound_jnd, found.feel.largest_jnd);
}

// A small part of what tests/bench/contracts_bench.cpp does with 200 edits and 10,000 strokes each.
TEST(TellingStroke, BeatsRandomStrokes) {
  base::Random random(4);
  const auto four = support::inventedExperts();
  const auto compiled = *fuzzy::compile(four);
  int beaten = 0;
  constexpr int kEdits = 8;
  for (int i = 0; i < kEdits; ++i) {
    const auto other = edited(four, [&](auto& model) {
      auto& expert = model.experts[static_cast<std::size_t>(random.below(4))];
      auto& rule = expert.rules[static_cast<std::size_t>(random.below(45))];
      rule.then = rule.then == "very_large" ? "small" : "very_large";
    });
    const auto compiled_other = *fuzzy::compile(other);
    double best = 0;
    for (int n = 0; n < 800; ++n) {
      Stroke stroke{random.uniform(0, 570), 0, random.uniform(5, 250), {random.uniform(), random.uniform(0, 90), 0, 0}};
      stroke.to_mm = random.uniform(stroke.from_mm + 30, 600);
      best = std::max(best, feelOf(compiled, compiled_other, {2, 3}, stroke).rms_jnd);
    }
    beaten += told(four, other, false).feel.rms_jnd >= best ? 1 : 0;
  }
  EXPECT_EQ(beaten, kEdits);
}

TEST(TellingStroke, MayBeStoppedAtAnyStep) {
  const auto s4 = support::s4FiveRegions();
  const auto other = edited(s4, referenceEdits()[0].change);
  const auto first = *fuzzy::compile(s4), second = *fuzzy::compile(other);
  for (int last = 1; last <= 40; ++last) {
    std::stop_source stop;
    int steps = 0;
    TellEffort effort;
    effort.bound = false;
    effort.progress = [&](double) {
      if (++steps == last) stop.request_stop();
    };
    const auto found = tell(s4, first, other, second, {}, effort, stop.get_token());
    ASSERT_TRUE(found) << last;
    EXPECT_LT(found->stroke.from_mm, found->stroke.to_mm) << last;
    EXPECT_EQ(found->stroke.inputs.size(), s4.inputs.size()) << last;
    if (steps < last) break;
  }
}

TEST(TellingStroke, ADeviceThatIsTooWeakForEachIsSaid) {
  const auto s4 = support::s4FiveRegions();
  const auto other = edited(s4, referenceEdits()[0].change);
  StrokeLimits weak;
  weak.device_n = 0.01;
  const auto none = tell(s4, *fuzzy::compile(s4), other, *fuzzy::compile(other), weak);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().message(), "found no stroke of at most 0.01 N, wanted a stroke that the device can give");
}

TEST(TellingStroke, Refusals) {
  const auto s4 = support::s4FiveRegions();
  auto other = s4;
  other.inputs[2].max = 700;
  const auto compiled = *fuzzy::compile(s4);
  EXPECT_FALSE(tell(s4, compiled, other, *fuzzy::compile(other)).has_value());
  auto without = s4;
  without.inputs[2].id = "way";
  for (auto& rule : without.experts[0].rules) {
    for (auto& condition : rule.conditions) condition.input = condition.input == "depth" ? "way" : condition.input;
  }
  EXPECT_FALSE(strokeInputs(without).has_value());
}

}  // namespace
}  // namespace tactus::contracts
