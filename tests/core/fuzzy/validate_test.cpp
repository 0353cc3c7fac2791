#include "core/fuzzy/validate.h"

#include <functional>
#include <gtest/gtest.h>
#include <limits>

#include "core/base/random.h"

#include "tests/support/ngt_model.h"
#include "tests/support/random_model.h"

namespace tactus::fuzzy {
namespace {

struct Case {
  const char* place;
  base::ErrorCode code;
  std::function<void(ForceModel&)> spoil;
};

TEST(Validate, AcceptsTheNgtModelAndRandomModels) {
  EXPECT_TRUE(validate(support::s4AsPrinted()).has_value());
  base::Random random(6);
  for (int i = 0; i < 500; ++i) {
    const auto ok = validate(support::randomModel(random, {.gaussians = true}));
    ASSERT_TRUE(ok.has_value()) << ok.error().message();
  }
}

TEST(Validate, EachMistakeIsFoundAtItsPlace) {
  using enum base::ErrorCode;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Case> cases = {
      {"/inputs", kSchema, [](auto& m) { m.inputs.clear(); }},
      {"/inputs", kLimit, [](auto& m) { m.inputs.resize(9, m.inputs[0]); }},
      {"/inputs/1/id", kSchema, [](auto& m) { m.inputs[1].id = "lubrication"; }},
      {"/inputs/0/id", kValue, [](auto& m) { m.inputs[0].id = ""; }},
      {"/inputs/0/id", kValue, [](auto& m) { m.inputs[0].id = std::string(65, 'x'); }},
      {"/inputs/0/id", kValue, [](auto& m) { m.inputs[0].id = "two\nlines"; }},
      {"/inputs/2/max", kValue, [](auto& m) { m.inputs[2].max = 0; }},
      {"/inputs/2/min", kValue, [nan](auto& m) { m.inputs[2].min = nan; }},
      {"/inputs/2/terms", kSchema, [](auto& m) { m.inputs[2].terms.clear(); }},
      {"/inputs/2/terms", kLimit, [](auto& m) { m.inputs[2].terms.resize(65, m.inputs[2].terms[0]); }},
      {"/inputs/2/terms/1/id", kSchema, [](auto& m) { m.inputs[2].terms[1].id = "nasal_cavity"; }},
      {"/inputs/2/terms/1/points/2", kValue, [](auto& m) { m.inputs[2].terms[1].points[2] = 70; }},
      {"/inputs/2/terms/1/points/3", kValue, [nan](auto& m) { m.inputs[2].terms[1].points[3] = nan; }},
      {"/inputs/2/terms/1/points/3", kValue, [](auto& m) { m.inputs[2].terms[1].points[3] = 1e200; }},
      {"/inputs/2/terms/1/points", kSchema, [](auto& m) { m.inputs[2].terms[1].points.pop_back(); }},
      {"/inputs/2/terms/1/points/1", kValue,
       [](auto& m) {
         m.inputs[2].terms[1] = {"g", "g", Shape::kGaussian, {1, 0}};
       }},
      {"/output/id", kSchema, [](auto& m) { m.output.id = "depth"; }},
      {"/output/terms/0/points", kValue,
       [](auto& m) {
         m.output.terms[0].points = {0, 0, 0, 0};
       }},
      {"/output/terms/0/points", kValue,
       [](auto& m) {
         m.output.terms[0].points = {1.1, 2, 3, 4};
       }},
      {"/output/terms/0/points", kValue,
       [](auto& m) {
         m.output.terms[0] = {"very_small", "", Shape::kGaussian, {-9, 0.1}};
       }},
      {"/default_force_n", kValue, [nan](auto& m) { m.default_force_n = nan; }},
      {"/experts", kSchema, [](auto& m) { m.experts.clear(); }},
      {"/experts", kValue, [](auto& m) { m.experts[0].weight = 0; }},
      {"/experts/0/weight", kValue, [](auto& m) { m.experts[0].weight = -1; }},
      {"/experts/1/id", kSchema, [](auto& m) { m.experts.push_back(m.experts[0]); }},
      {"/experts/0/terms/taste", kReference,
       [](auto& m) {
         m.experts[0].overrides = {{"taste", m.inputs[0].terms}};
       }},
      {"/experts/0/terms/force/0/points", kValue,
       [](auto& m) {
         m.experts[0].overrides = {{"force", {{"t", "t", Shape::kTriangle, {2, 3, 4}}}}};
       }},
      {"/experts/0/rules/0/if/lubrication", kReference,
       [](auto& m) {
         m.experts[0].overrides = {{"lubrication", {m.inputs[0].terms[0]}}};
       }},
      {"/experts/0/rules", kLimit, [](auto& m) { m.experts[0].rules.resize(4097, m.experts[0].rules[0]); }},
      {"/experts/0/rules/7/if", kSchema, [](auto& m) { m.experts[0].rules[7].conditions.clear(); }},
      {"/experts/0/rules/7/if/taste", kReference, [](auto& m) { m.experts[0].rules[7].conditions[0].input = "taste"; }},
      {"/experts/0/rules/7/if/force", kReference, [](auto& m) { m.experts[0].rules[7].conditions[0].input = "force"; }},
      {"/experts/0/rules/7/if/depth", kSchema,
       [](auto& m) {
         m.experts[0].rules[7].conditions[0] = {"depth", "stomach"};
       }},
      {"/experts/0/rules/7/if/depth", kReference, [](auto& m) { m.experts[0].rules[7].conditions[1].term = "knee"; }},
      {"/experts/0/rules/7/then", kReference, [](auto& m) { m.experts[0].rules[7].then = "huge"; }},
      {"/experts/0/rules/7/weight", kValue, [](auto& m) { m.experts[0].rules[7].weight = 1.5; }},
      {"/experts/0/rules/45", kSchema,
       [](auto& m) {
         auto rule = m.experts[0].rules[3];
         std::swap(rule.conditions[0], rule.conditions[1]);
         m.experts[0].rules.push_back(rule);
       }},
      {"/renderer/version", kVersion, [](auto& m) { m.renderer.emplace().version = 2; }},
      {"/renderer/stiffness_n_mm", kValue, [](auto& m) { m.renderer.emplace().stiffness_n_mm = 0; }},
      {"/events", kLimit,
       [](auto& m) {
         m.events.resize(9, {"nasopharynx", 0.5});
       }},
      {"/events", kReference,
       [](auto& m) {
         m.inputs[2].role = Role::kCondition;
         m.events = {{"nasopharynx", 0.5}};
       }},
      {"/events/0/term", kReference,
       [](auto& m) {
         m.events = {{"slow", 0.5}};
       }},
      {"/events/1/term", kSchema,
       [](auto& m) {
         m.events = {{"nasopharynx", 0.5}, {"nasopharynx", 0.25}};
       }},
      {"/events/0/share", kValue,
       [](auto& m) {
         m.events = {{"nasopharynx", 0}};
       }},
      {"/events/0/share", kValue,
       [](auto& m) {
         m.events = {{"nasopharynx", 1}};
       }},
      {"/events/0/share", kValue,
       [nan](auto& m) {
         m.events = {{"nasopharynx", nan}};
       }},
      {"/checks/0/in", kSchema,
       [](auto& m) {
         m.checks = {{{1, 2}, 0, true}};
       }},
      {"/checks/0/in/2", kValue,
       [nan](auto& m) {
         m.checks = {{{1, 2, nan, 4}, 0, true}};
       }},
  };
  for (const auto& mistake : cases) {
    ForceModel model = support::s4AsPrinted();
    mistake.spoil(model);
    const auto result = validate(model);
    ASSERT_FALSE(result.has_value()) << mistake.place;
    EXPECT_EQ(result.error().place, mistake.place) << result.error().message();
    EXPECT_EQ(result.error().code, mistake.code) << result.error().message();
    EXPECT_EQ(result.error().message().find('\n'), std::string::npos);
  }
}

// Experts who answer the same items share what was read of the first of them.
TEST(Validate, MistakesOfALaterExpertAreFoundToo) {
  using enum base::ErrorCode;
  const std::vector<Case> cases = {
      {"/experts/1/rules/7/if", kSchema, [](auto& m) { m.experts[1].rules[7].conditions.clear(); }},
      {"/experts/1/rules/7/if/depth", kReference, [](auto& m) { m.experts[1].rules[7].conditions[1].term = "knee"; }},
      {"/experts/1/rules/7/then", kReference, [](auto& m) { m.experts[1].rules[7].then = "huge"; }},
      {"/experts/1/rules/7/weight", kValue, [](auto& m) { m.experts[1].rules[7].weight = -0.5; }},
      {"/experts/1/rules/45", kSchema, [](auto& m) { m.experts[1].rules.push_back(m.experts[1].rules[7]); }},
      {"/experts/1/rules/8", kSchema, [](auto& m) { m.experts[1].rules[8] = m.experts[1].rules[7]; }},
      {"/experts/1/rules/0/if/lubrication", kReference,
       [](auto& m) {
         auto terms = m.inputs[0].terms;
         terms[2].id = "very_well";
         m.experts[1].overrides.push_back({"lubrication", terms});
       }},
  };
  for (const auto& mistake : cases) {
    ForceModel model = support::s4AsPrinted();
    model.experts.push_back(model.experts[0]);
    model.experts[1].id = "S5";
    ASSERT_TRUE(validate(model).has_value());
    mistake.spoil(model);
    const auto result = validate(model);
    ASSERT_FALSE(result.has_value()) << mistake.place;
    EXPECT_EQ(result.error().place, mistake.place) << result.error().message();
    EXPECT_EQ(result.error().code, mistake.code) << result.error().message();
  }
}

TEST(Validate, TheSameConditionsWithAnotherConsequentAreNoError) {
  ForceModel model = support::s4AsPrinted();
  auto rule = model.experts[0].rules[0];
  rule.then = "very_large";
  model.experts[0].rules.push_back(rule);
  EXPECT_TRUE(validate(model).has_value());
}

}  // namespace
}  // namespace tactus::fuzzy
