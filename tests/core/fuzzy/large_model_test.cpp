// Models beyond the usual size keep the fast form and stay exact: many output terms, experts, rules, own terms.
#include <algorithm>
#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/fuzzy/batch.h"
#include "core/fuzzy/model_tables.h"

#include "tests/stress/agreement.h"
#include "tests/support/ngt_model.h"
#include "tests/support/random_model.h"

namespace tactus::fuzzy {
namespace {

std::string idOf(int number) { return "t" + std::to_string(number); }

/// `count` trapezoids over [0, 1], each reaching `reach` pitches beyond its middle.
Variable evenVariable(const std::string& id, int count, double reach) {
  Variable variable{id, id, "1", 0, 1, {}};
  const double pitch = 1.0 / count;
  for (int t = 0; t < count; ++t) {
    const double middle = (t + 0.5) * pitch;
    const double a = t == 0 ? 0 : std::max(0.0, middle - reach * pitch);
    const double d = t == count - 1 ? 1 : std::min(1.0, middle + reach * pitch);
    variable.terms.push_back({idOf(t), idOf(t), Shape::kTrapezoid, {a, middle, middle, d}});
  }
  return variable;
}

/// Rules with one to all inputs, with terms and weights drawn at random.
ForceModel evenModel(base::Random& random, int inputs, int input_terms, int output_terms, double reach, int rules) {
  ForceModel model;
  model.name = "even";
  for (int i = 0; i < inputs; ++i) model.inputs.push_back(evenVariable("x" + std::to_string(i), input_terms, 0.75));
  model.output = evenVariable("y", output_terms, reach);
  Expert expert{"E0", "E0", 1, {}, {}};
  for (int r = 0; r < rules; ++r) {
    Rule rule;
    const int first = random.below(inputs);
    for (int i = first; i < inputs; ++i) {
      rule.conditions.push_back({model.inputs[static_cast<std::size_t>(i)].id, idOf(random.below(input_terms))});
    }
    rule.then = idOf(random.below(output_terms));
    rule.weight = random.below(3) == 0 ? random.uniform(0.1, 1) : 1;
    const auto is_same = [&rule](const Rule& other) {
      return rule.conditions == other.conditions && rule.then == other.then;
    };
    if (std::none_of(expert.rules.begin(), expert.rules.end(), is_same)) expert.rules.push_back(rule);
  }
  model.experts.push_back(std::move(expert));
  return model;
}

/// Another expert with some consequents moved by a step.
Expert variation(base::Random& random, const Expert& expert, int number, int output_terms) {
  Expert other = expert;
  other.id = other.label = "E" + std::to_string(number);
  other.weight = random.below(4) == 0 ? 0 : random.uniform(0.1, 2);
  std::vector<Rule> kept;
  for (Rule& rule : other.rules) {
    if (random.below(4) == 0) continue;  // so that experts abstain somewhere
    if (random.below(3) == 0) rule.then = idOf(random.below(output_terms));
    const auto is_same = [&rule](const Rule& r) { return rule.conditions == r.conditions && rule.then == r.then; };
    if (std::none_of(kept.begin(), kept.end(), is_same)) kept.push_back(rule);
  }
  other.rules = std::move(kept);
  return other;
}

void expectFastAndExact(const ForceModel& model, base::Random& random, int points) {
  const auto compiled = compile(model);
  ASSERT_TRUE(compiled.has_value()) << compiled.error().message();
  EXPECT_TRUE(compiled->tables().program.usable);
  const auto found = stress::checkBuildment(model, random, points);
  ASSERT_FALSE(found.disagreement.has_value()) << *found.disagreement;
  EXPECT_LE(found.largest_ulps, 4);
}

TEST(LargeModel, ManyOutputTerms) {
  base::Random random(51);
  for (const int terms : {9, 16, 40, 64}) {
    for (const auto implication : {Implication::kClip, Implication::kScale}) {
      ForceModel model = evenModel(random, 3, 5, terms, 0.75, 60);
      model.implication = implication;
      expectFastAndExact(model, random, 20);
    }
  }
}

TEST(LargeModel, OutputTermsThatOverlapBeyondTheirNeighbors) {
  base::Random random(52);
  for (const int terms : {3, 5, 8, 12}) {
    for (const double reach : {1.2, 1.8, 2.6, 4.1}) {
      for (int m = 0; m < 5; ++m) expectFastAndExact(evenModel(random, 2, 4, terms, reach, 20), random, 20);
    }
  }
}

TEST(LargeModel, SeveralExpertsShareTheirTerms) {
  base::Random random(53);
  for (const int experts : {2, 3, 4, 5, 9}) {
    for (const auto implication : {Implication::kClip, Implication::kScale}) {
      for (const double reach : {0.75, 1.6}) {
        if (implication == Implication::kScale && reach > 1) continue;  // the general path has those
        ForceModel model = evenModel(random, 3, 4, 6, reach, 40);
        model.implication = implication;
        for (int e = 1; e < experts; ++e) model.experts.push_back(variation(random, model.experts.front(), e, 6));
        expectFastAndExact(model, random, 40);
      }
    }
  }
}

TEST(LargeModel, ManyExpertsWithTermsOfTheirOwn) {
  base::Random random(54);
  ForceModel model = support::s4FiveRegions();
  for (int e = 1; e < 40; ++e) {
    Expert expert = model.experts.front();
    expert.id = "E" + std::to_string(e);
    for (const Variable& input : model.inputs) {
      std::vector<Term> terms = input.terms;
      for (Term& term : terms) {
        for (double& point : term.points) {
          if (point > input.min && point < input.max) point += 0.01 * e / 40 * (input.max - input.min);
        }
      }
      expert.overrides.push_back({input.id, std::move(terms)});
    }
    model.experts.push_back(std::move(expert));
  }
  expectFastAndExact(model, random, 10);
}

/// Ulps between batch and point at `points` random points of `count` experts with the rules of S4.
double largestUlps(int count, base::Random& random, std::size_t points) {
  ForceModel model = support::s4FiveRegions();
  while (model.experts.size() < static_cast<std::size_t>(count)) {
    model.experts.push_back(model.experts.front());
    model.experts.back().id = "E" + std::to_string(model.experts.size());
  }
  const CompiledModel compiled = compile(model).value();
  std::vector<std::vector<double>> columns;
  for (const Variable& input : model.inputs) {
    auto& column = columns.emplace_back(points);
    for (double& x : column) x = random.uniform(input.min, input.max);
  }
  std::vector<double> force_n(points);
  std::vector<std::uint8_t> fired(points);
  const std::vector<std::span<const double>> inputs(columns.begin(), columns.end());
  evaluateBatch(compiled, inputs, {force_n, fired});
  double largest = 0;
  for (std::size_t p = 0; p < points; ++p) {
    std::vector<double> point;
    for (const auto& column : columns) point.push_back(column[p]);
    const Evaluation one = compiled.evaluate(point);
    EXPECT_EQ(one.fired, fired[p] != 0);
    largest = std::max(largest, stress::entryPointUlps(one.force_n, force_n[p], model.output.min));
  }
  return largest;
}

// Equal experts are the worst case: all additions round alike.
TEST(LargeModel, TheOrderOfTheExpertsCountsFromSeventeenOn) {
  base::Random random(57);
  for (const int experts : {1, 2, 4, 5, 8, 15, 16}) EXPECT_LE(largestUlps(experts, random, 2000), 4) << experts;
  for (const int experts : {100, 1024}) EXPECT_LE(largestUlps(experts, random, 300), 1.25 * experts) << experts;
}

TEST(LargeModel, ThousandsOfRules) {
  base::Random random(55);
  expectFastAndExact(evenModel(random, 4, 8, 8, 0.75, 3000), random, 5);
}

// Where inputs are fixed, rules of any weight keep what is left of their conditions.
TEST(LargeModel, EverySubsetOfInputsCanBeFixed) {
  base::Random random(56);
  for (int m = 0; m < 300; ++m) {
    ForceModel model = evenModel(random, 4, 3, 5, m % 2 == 0 ? 0.75 : 1.4, 30);
    model.experts.push_back(variation(random, model.experts.front(), 1, 5));
    const auto compiled = compile(model);
    ASSERT_TRUE(compiled->tables().program.usable);
    const auto found = stress::checkBuildment(model, random, 4);
    ASSERT_FALSE(found.disagreement.has_value()) << *found.disagreement;
  }
}

}  // namespace
}  // namespace tactus::fuzzy
