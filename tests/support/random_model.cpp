#include "tests/support/random_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace tactus::support {
namespace {

using base::Random;
using fuzzy::ForceModel;
using fuzzy::Shape;
using fuzzy::Term;
using fuzzy::Variable;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double fewUlpsBeside(Random& random, double x) {
  const int steps = random.below(5) - 2;
  for (int i = 0; i < std::abs(steps); ++i) x = std::nextafter(x, steps > 0 ? kInfinity : -kInfinity);
  return x;
}

/// A vertex: on a coarse grid (so that vertices coincide), anywhere, or outside the universe.
double randomVertex(Random& random, const Variable& v) {
  const double width = v.max - v.min;
  switch (random.below(4)) {
    case 0: return v.min + width * random.below(9) / 8;
    case 1: return v.min + width * random.uniform(-0.5, 1.5);
    default: return v.min + width * random.uniform();
  }
}

Term randomTerm(Random& random, const Variable& v, const RandomModelOptions& options) {
  Term term;
  if (options.gaussians && random.below(2) == 0) {
    term.shape = Shape::kGaussian;
    term.points = {randomVertex(random, v), (v.max - v.min) * random.uniform(0.02, 0.6)};
    return term;
  }
  term.shape = random.below(4) == 0 ? Shape::kTriangle : Shape::kTrapezoid;
  for (std::size_t i = 0; i < pointCount(term.shape); ++i) {
    const bool near_last = options.adversarial && i > 0 && random.below(8) == 0;
    term.points.push_back(near_last ? fewUlpsBeside(random, term.points.back()) : randomVertex(random, v));
  }
  std::sort(term.points.begin(), term.points.end());
  if (random.below(4) == 0) term.points[1] = term.points[0];
  if (random.below(4) == 0) term.points[term.points.size() - 2] = term.points.back();
  return term;
}

bool meetsUniverse(const Term& term, const Variable& v) {
  return term.shape == Shape::kGaussian || std::min(term.points.back(), v.max) > std::max(term.points.front(), v.min);
}

std::vector<Term> randomTerms(Random& random, const Variable& v, bool output, const RandomModelOptions& options) {
  std::vector<Term> terms;
  const int count = 1 + random.below(6);
  while (std::cmp_less(terms.size(), count)) {
    Term term = randomTerm(random, v, options);
    if (output && !meetsUniverse(term, v)) continue;
    std::sort(term.points.begin(), term.points.end());
    if (term.shape == Shape::kGaussian) {
      term.points = {randomVertex(random, v), (v.max - v.min) * random.uniform(0.02, 0.6)};
    }
    term.id = "t" + std::to_string(terms.size());
    term.label = "Term " + std::to_string(terms.size());
    terms.push_back(std::move(term));
  }
  return terms;
}

Variable randomVariable(Random& random, std::string id, bool output, const RandomModelOptions& options) {
  Variable v;
  v.label = id;
  v.id = std::move(id);
  v.unit = "1";
  switch (options.adversarial ? random.below(6) : 5) {
    case 0: v.min = 0, v.max = 1e-7; break;
    case 1: v.min = -1e6, v.max = 1e6; break;
    case 2: v.min = 1e6, v.max = 1e6 + 1; break;
    case 3: v.min = 0, v.max = 1; break;
    default: v.min = random.uniform(-2, 2), v.max = v.min + random.uniform(0.1, 3);
  }
  v.terms = randomTerms(random, v, output, options);
  return v;
}

double randomWeight(Random& random, const RandomModelOptions& options) {
  switch (random.below(6)) {
    case 0: return random.uniform();
    case 1: return options.adversarial ? std::pow(10.0, random.uniform(-300, 0)) : random.uniform();
    case 2: return 0;
    default: return 1;
  }
}

const std::string& randomTermId(Random& random, const std::vector<Term>& terms) {
  return terms[static_cast<std::size_t>(random.below(static_cast<int>(terms.size())))].id;
}

bool sameRule(const fuzzy::Rule& a, const fuzzy::Rule& b) { return a.conditions == b.conditions && a.then == b.then; }

}  // namespace

ForceModel randomModel(Random& random, const RandomModelOptions& options) {
  ForceModel model;
  model.name = "random";
  model.created_utc = "2026-01-01T00:00:00Z";
  model.generator = "test";
  model.implication = random.below(2) == 0 ? fuzzy::Implication::kClip : fuzzy::Implication::kScale;
  model.default_force_n = random.uniform(-1, 1);
  const int inputs = 1 + random.below(4);
  for (int i = 0; i < inputs; ++i) {
    model.inputs.push_back(randomVariable(random, "x" + std::to_string(i), false, options));
  }
  model.output = randomVariable(random, "y", true, options);

  const int experts = 1 + random.below(4);
  for (int e = 0; e < experts; ++e) {
    fuzzy::Expert expert;
    expert.id = "E" + std::to_string(e);
    expert.label = "Expert " + std::to_string(e);
    expert.weight = e == 0 ? 1 : random.uniform(0, 3) * (random.below(4) > 0);
    for (const auto& input : model.inputs) {
      if (random.below(5) == 0) expert.overrides.push_back({input.id, randomTerms(random, input, false, options)});
    }
    if (random.below(5) == 0)
      expert.overrides.push_back({model.output.id, randomTerms(random, model.output, true, options)});
    const int rules = random.below(12);
    for (int r = 0; r < rules; ++r) {
      fuzzy::Rule rule;
      for (const auto& input : model.inputs) {
        if (random.below(2) == 0) rule.conditions.push_back({input.id, randomTermId(random, termsFor(expert, input))});
      }
      if (rule.conditions.empty()) continue;
      rule.then = randomTermId(random, termsFor(expert, model.output));
      rule.weight = randomWeight(random, options);
      rule.enabled = random.below(10) > 0;
      const bool known = std::any_of(expert.rules.begin(), expert.rules.end(),
                                     [&](const auto& other) { return sameRule(rule, other); });
      if (!known) expert.rules.push_back(std::move(rule));
    }
    model.experts.push_back(std::move(expert));
  }
  return model;
}

std::vector<double> randomPoint(Random& random, const ForceModel& model) {
  std::vector<double> point;
  for (const auto& input : model.inputs) {
    const auto& term = input.terms[static_cast<std::size_t>(random.below(static_cast<int>(input.terms.size())))];
    const double vertex = term.points[static_cast<std::size_t>(random.below(static_cast<int>(term.points.size())))];
    switch (random.below(4)) {
      case 0: point.push_back(vertex); break;
      case 1: point.push_back(fewUlpsBeside(random, vertex)); break;
      default: point.push_back(random.uniform(input.min, input.max) + (random.below(20) == 0 ? input.max : 0));
    }
  }
  return point;
}

void takeExtremeWeights(base::Random& random, fuzzy::ForceModel& model) {
  constexpr std::array kWeights = {5e-324, 1.5e-323, 1e-300, 1e-150, 1e-20, 1.0, 3.0, 1e20, 1e150, 1e308, 1.79e308};
  for (auto& expert : model.experts)
    expert.weight = kWeights[static_cast<std::size_t>(random.below(static_cast<int>(kWeights.size())))];
}

}  // namespace tactus::support
