// Contracts over the whole box, with exact rational arithmetic as the referee.
#include "core/contracts/contract_check.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/base/random.h"

#include "tests/reference/exact_model.h"
#include "tests/support/invented_experts.h"
#include "tests/support/ngt_model.h"
#include "tests/support/ordered_model.h"

namespace tactus::contracts {
namespace {

using Kind = fuzzy::Contract::Kind;

fuzzy::Contract contractOf(const fuzzy::ForceModel& model, std::string_view sentence) {
  const auto contract = parseContract(model, sentence);
  EXPECT_TRUE(contract.has_value()) << (contract ? "" : contract.error().message());
  return contract.value_or(fuzzy::Contract{});
}

ContractResult check(const fuzzy::ForceModel& model, std::string_view sentence) {
  return checkContract(model, *fuzzy::compile(model), contractOf(model, sentence));
}

double exact(const fuzzy::ForceModel& model, const std::vector<double>& at) {
  const auto force = reference::exactForce(model, at);
  return force ? force->get_d() : model.default_force_n;
}

/// How much a contract about two points, or one, is violated by exact arithmetic.
double exactExcess(const fuzzy::ForceModel& model, const fuzzy::Contract& contract, const std::vector<double>& first,
                   const std::vector<double>& second) {
  const double a = exact(model, first);
  const double b = exact(model, second);
  switch (contract.kind) {
    case Kind::kNeverRaises: return b - a;
    case Kind::kNeverLowers:
    case Kind::kNeverHarder: return a - b;
    case Kind::kNeverAbove: return a - contract.limit;
    case Kind::kNeverBelow: return contract.limit - a;
    case Kind::kNoStep: {
      const double least = std::min(std::abs(a), std::abs(b));
      return std::abs(a - b) - contract.limit * (contract.limit_in_jnd ? justNoticeableDifference(least) : 1.0);
    }
    case Kind::kNeverSilent: return reference::exactForce(model, first) ? -1 : 1;
  }
  return 0;
}

/// What is reported must be so by exact arithmetic: a violation there, and none of a proved contract at random places.
void expectReferee(const fuzzy::ForceModel& model, const fuzzy::Contract& contract, const ContractResult& result,
                   base::Random& random, int places) {
  if (result.verdict == Verdict::kViolated) {
    ASSERT_FALSE(result.counterexample.empty());
    const auto& first = result.counterexample.front().inputs;
    const auto& second = result.counterexample.back().inputs;
    const double excess = exactExcess(model, contract, first, second);
    EXPECT_GT(excess, 0) << sentenceOf(model, contract);
    if (contract.kind != Kind::kNeverSilent) {
      EXPECT_NEAR(excess, result.excess_n, 1e-11);
    }
    return;
  }
  if (result.verdict != Verdict::kProved) return;
  std::size_t along = 0;
  while (along < model.inputs.size() && model.inputs[along].id != contract.input) ++along;
  for (int i = 0; i < places; ++i) {
    std::vector<double> first = support::randomOrderedPoint(random, model);
    std::vector<double> second = first;
    if (along < model.inputs.size()) {
      second[along] = support::randomOrderedPoint(random, model)[along];
      if (contract.kind == Kind::kNeverHarder) continue;
      if (contract.kind == Kind::kNoStep)
        second[along] = std::clamp(first[along] + contract.within * random.uniform(-1, 1), model.inputs[along].min,
                                   model.inputs[along].max);
      if (second[along] < first[along]) std::swap(first, second);
    }
    EXPECT_LE(exactExcess(model, contract, first, second), result.bound_n.value_or(0) + 1e-12)
        << sentenceOf(model, contract);
  }
}

// Reference figures, from another program: at flexion 65, depth 52.9, speed 185 lubrication .44 -> .70 raises the force
// by .067 N, although no rule of S4 says more force for more lubrication.
TEST(ContractCheck, TheModelOfS4RisesWithLubrication) {
  const auto model = support::s4FiveRegions();
  const auto result = check(model, "more lubrication never raises the force");
  EXPECT_EQ(result.verdict, Verdict::kViolated);
  EXPECT_GE(result.excess_n, 0.067);
  ASSERT_EQ(result.counterexample.size(), 2U);
  const auto& [from, to] = std::pair(result.counterexample[0], result.counterexample[1]);
  EXPECT_LT(from.inputs[0], to.inputs[0]);
  EXPECT_NEAR(exact(model, to.inputs) - exact(model, from.inputs), result.excess_n, 1e-12);
}

// The same source: speed lowers the force by up to .032 N somewhere.
TEST(ContractCheck, AndFallsWithSpeed) {
  const auto result = check(support::s4FiveRegions(), "more speed never lowers the force");
  EXPECT_EQ(result.verdict, Verdict::kViolated);
  EXPECT_NEAR(result.excess_n, 0.032, 0.0005);
}

// The same source: it held at 60,000 random places.
TEST(ContractCheck, TheNasalCavityIsNeverHarderThanTheLaryngopharynx) {
  for (const auto& model : {support::s4FiveRegions(), support::inventedExperts()}) {
    EXPECT_EQ(check(model, "depth in nasal cavity is never harder than in laryngopharynx").verdict, Verdict::kProved);
    EXPECT_EQ(check(model, "depth in laryngopharynx is never harder than in nasal cavity").verdict, Verdict::kViolated);
  }
}

// A term alone never goes below or above its own centroid: VS .126667, VL .923810 (hand calculation).
TEST(ContractCheck, LimitsOfTheForce) {
  const auto model = support::s4FiveRegions();
  EXPECT_EQ(check(model, "the force is never above 0.9239 N").verdict, Verdict::kProved);
  const auto above = check(model, "the force is never above 0.9238 N");
  EXPECT_EQ(above.verdict, Verdict::kViolated);
  EXPECT_NEAR(above.excess_n, 0.92380952380952 - 0.9238, 1e-9);
  EXPECT_EQ(check(model, "the force is never below 0.12 N").verdict, Verdict::kProved);
  EXPECT_EQ(check(model, "the force is never above 0.4 N where depth is nasal cavity and lubrication is well").verdict,
            Verdict::kViolated);
  EXPECT_EQ(check(model, "the force is never above 0.7 N where speed is slow and lubrication is well").verdict,
            Verdict::kViolated);
}

TEST(ContractCheck, SilentPlaces) {
  EXPECT_EQ(check(support::s4FiveRegions(), "the model is never silent").verdict, Verdict::kProved);
  // As printed, no rule names the oropharynx: 125 to 138 mm.
  const auto printed = support::s4AsPrinted();
  const auto result = check(printed, "the model is never silent");
  EXPECT_EQ(result.verdict, Verdict::kViolated);
  ASSERT_EQ(result.counterexample.size(), 1U);
  EXPECT_FALSE(result.counterexample[0].force.fired);
  EXPECT_GE(result.counterexample[0].inputs[2], 125);
  EXPECT_LE(result.counterexample[0].inputs[2], 138);
  EXPECT_EQ(check(printed, "the model is never silent where depth is esophagus").verdict, Verdict::kProved);
  // A single place between two feet counts.
  auto touching = support::s4FiveRegions();
  auto& terms = touching.inputs[0].terms;
  terms[0].points = {0, 0, 0.2, 0.3};
  terms[1].points = {0.3, 0.4, 0.6, 0.8};
  std::erase_if(touching.experts[0].rules, [](const auto& rule) { return rule.conditions[0].input != "lubrication"; });
  const auto at = check(touching, "the model is never silent");
  EXPECT_EQ(at.verdict, Verdict::kViolated);
  EXPECT_EQ(at.counterexample.at(0).inputs[0], 0.3);
}

TEST(ContractCheck, Steps) {
  const auto four = support::inventedExperts();
  EXPECT_EQ(check(four, "the force never changes by more than 1 JND within 1 mm of depth").verdict, Verdict::kProved);
  auto cliff = four;
  for (auto& term : cliff.inputs[2].terms) {
    if (term.id == "nasal_cavity") term.points = {0, 0, 70, 70.5};
    if (term.id == "nasopharynx") term.points = {70, 70.5, 105, 125};
  }
  const auto result = check(cliff, "the force never changes by more than 1 JND within 1 mm of depth");
  EXPECT_EQ(result.verdict, Verdict::kViolated);
  ASSERT_EQ(result.counterexample.size(), 2U);
  EXPECT_LE(std::abs(result.counterexample[0].inputs[2] - result.counterexample[1].inputs[2]), 1);
}

/// Monotone by construction: one input, each term in full says its own word, in order.
fuzzy::ForceModel monotoneModel() {
  auto model = support::s4FiveRegions();
  model.inputs.resize(1);
  auto& rules = model.experts[0].rules;
  rules = {{{{"lubrication", "poor"}}, "very_large"},
           {{{"lubrication", "medium"}}, "medium"},
           {{{"lubrication", "well"}}, "very_small"}};
  return model;
}

TEST(ContractCheck, ProvesWhatRisesNowhere) {
  const auto model = monotoneModel();
  const auto result = check(model, "more lubrication never raises the force");
  EXPECT_EQ(result.verdict, Verdict::kProved) << result.reason;
  EXPECT_EQ(check(model, "more lubrication never lowers the force").verdict, Verdict::kViolated);
}

// The smallest change of a limit that a violation shows: 1e-6 N.
TEST(ContractCheck, FindsPlantedViolationsOfAMillionthOfANewton) {
  base::Random random(37);
  int planted = 0;
  for (int i = 0; i < 12; ++i) {
    auto model = support::s4FiveRegions();
    // Anywhere, from two words that meet nowhere else.
    const double largest = check(model, "the force is never above 0 N").excess_n;
    fuzzy::Contract contract = contractOf(model, "the force is never above 1 N");
    contract.limit = largest - 1e-6 * random.uniform(1, 3);
    const auto result = checkContract(model, *fuzzy::compile(model), contract);
    EXPECT_EQ(result.verdict, Verdict::kViolated);
    planted += result.verdict == Verdict::kViolated ? 1 : 0;
    contract.limit = largest + 1e-6;
    EXPECT_EQ(checkContract(model, *fuzzy::compile(model), contract).verdict, Verdict::kProved);
  }
  EXPECT_EQ(planted, 12);
  // A rise: the word for medium lubrication is a millionth of a newton below that for well.
  auto model = monotoneModel();
  for (const double lower_n : {1e-6, 2e-6, 5e-6}) {
    auto rising = model;
    auto low = rising.output.terms[0];
    low.id = "lower";
    for (double& point : low.points) point = std::max(0.0, point - 4 * lower_n);
    low.points[0] = low.points[1] = 0;
    rising.output.terms = {low, rising.output.terms[0]};
    rising.experts[0].rules = {{{{"lubrication", "poor"}}, "very_small"},
                               {{{"lubrication", "medium"}}, "lower"},
                               {{{"lubrication", "well"}}, "very_small"}};
    const auto result = check(rising, "more lubrication never raises the force");
    const double rise = exact(rising, {1}) - exact(rising, {0.5});
    ASSERT_GE(rise, 1e-6);
    EXPECT_EQ(result.verdict, Verdict::kViolated) << rise;
    EXPECT_GE(result.excess_n, rise - 1e-12);
  }
}

// Random models of the kind that people make: nothing is reported that exact arithmetic does not confirm.
TEST(ContractCheck, RandomModelsAgreeWithExactArithmetic) {
  base::Random random(5);
  std::size_t verdicts[3] = {};
  for (int i = 0; i < 16; ++i) {
    const auto model = support::randomOrderedModel(random);
    const auto compiled = *fuzzy::compile(model);
    const auto& input = model.inputs[static_cast<std::size_t>(random.below(static_cast<int>(model.inputs.size())))];
    const double share = random.uniform(0.2, 1);
    std::vector<fuzzy::Contract> contracts(6);
    contracts[0].kind = Kind::kNeverRaises;
    contracts[1].kind = Kind::kNeverLowers;
    contracts[2].kind = Kind::kNeverAbove;
    contracts[2].limit = model.output.min + share * (model.output.max - model.output.min);
    contracts[3].kind = Kind::kNeverSilent;
    contracts[4].kind = Kind::kNoStep;
    contracts[4].within = (input.max - input.min) / 100;
    contracts[4].limit = (model.output.max - model.output.min) * 0.1;
    contracts[5].kind = Kind::kNeverHarder;
    contracts[5].word = input.terms.front().id;
    contracts[5].than = input.terms.back().id;
    for (auto& contract : contracts) {
      contract.input = input.id;
      const auto result = checkContract(model, compiled, contract, {.parts = 1'500});
      ++verdicts[static_cast<int>(result.verdict)];
      ASSERT_NO_FATAL_FAILURE(expectReferee(model, contract, result, random, 10)) << "model " << i;
    }
  }
  EXPECT_GT(verdicts[0], 10U);
  EXPECT_GT(verdicts[1], 25U);
}

TEST(ContractCheck, ALostNameIsOpen) {
  const auto model = support::s4FiveRegions();
  auto contract = contractOf(model, "the force is never above 1 N where speed is slow");
  contract.where[0].term = "walking";
  const auto result = checkContract(model, *fuzzy::compile(model), contract);
  EXPECT_EQ(result.verdict, Verdict::kOpen);
  EXPECT_NE(result.reason.find("walking"), std::string::npos);
}

TEST(ContractCheck, StopsWhenAsked) {
  std::stop_source source;
  source.request_stop();
  const auto model = support::inventedExperts();
  const auto result = checkContract(
      model, *fuzzy::compile(model),
      contractOf(model, "the force never changes by more than 1 JND within 1 mm of depth"), {}, source.get_token());
  EXPECT_NE(result.verdict, Verdict::kProved);
}

}  // namespace
}  // namespace tactus::contracts
