#include "tests/bench/cost_models.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "core/base/random.h"

namespace tactus::bench {
namespace {

constexpr std::uint64_t kCostSeed = 20261122;

/// Equal trapezoids from 0 to 1, neighbors overlapping, shoulders at the ends.
fuzzy::Variable evenVariable(const std::string& id, int terms) {
  fuzzy::Variable variable{id, id, "1", 0, 1, {}};
  const double pitch = 1.0 / terms;
  for (int t = 0; t < terms; ++t) {
    const double a = t == 0 ? 0 : (t - 0.25) * pitch;
    const double b = t == 0 ? 0 : (t + 0.25) * pitch;
    const double c = t == terms - 1 ? 1 : (t + 0.75) * pitch;
    const double d = t == terms - 1 ? 1 : (t + 1.25) * pitch;
    const std::string name = "t" + std::to_string(t);
    variable.terms.push_back({name, name, fuzzy::Shape::kTrapezoid, {a, b, c, d}});
  }
  return variable;
}

std::string termId(int t) { return "t" + std::to_string(t); }

fuzzy::ForceModel evenModel(int inputs, int input_terms, int output_terms) {
  fuzzy::ForceModel model;
  model.name = "synthetic";
  for (int i = 0; i < inputs; ++i) model.inputs.push_back(evenVariable("x" + std::to_string(i), input_terms));
  model.output = evenVariable("y", output_terms);
  model.experts.push_back({"synthetic", "Synthetic", 1, {}, {}});
  return model;
}

/// A rule for each term of the first input: one of them fires wherever the point lies.
void addCoveringRules(fuzzy::ForceModel& model) {
  const auto terms = static_cast<int>(model.inputs[0].terms.size());
  const auto output_terms = static_cast<int>(model.output.terms.size());
  for (int t = 0; t < terms; ++t) {
    model.experts[0].rules.push_back({{{"x0", termId(t)}}, termId(t * output_terms / terms)});
  }
}

}  // namespace

fuzzy::ForceModel modelWithRules(int rules) {
  constexpr int kTerms = 8;
  fuzzy::ForceModel model = evenModel(4, kTerms, kTerms);
  addCoveringRules(model);
  std::vector<int> cells(kTerms * kTerms * kTerms * kTerms);
  std::iota(cells.begin(), cells.end(), 0);
  base::Random random(kCostSeed);
  auto& list = model.experts[0].rules;
  for (std::size_t left = cells.size(); static_cast<int>(list.size()) < rules; --left) {
    std::swap(cells[left - 1], cells[static_cast<std::size_t>(random.below(static_cast<int>(left)))]);
    fuzzy::Rule rule;
    int cell = cells[left - 1];
    for (const auto& input : model.inputs) {
      rule.conditions.push_back({input.id, termId(cell % kTerms)});
      cell /= kTerms;
    }
    rule.then = termId(random.below(kTerms));
    list.push_back(std::move(rule));
  }
  return model;
}

fuzzy::ForceModel modelWithTerms(int terms) {
  constexpr std::size_t kRules = 128;
  fuzzy::ForceModel model = evenModel(4, terms, terms);
  addCoveringRules(model);
  base::Random random(kCostSeed);
  std::set<std::vector<int>> known;
  auto& list = model.experts[0].rules;
  while (list.size() < kRules) {
    const int first = random.below(4);
    const int second = (first + 1 + random.below(3)) % 4;
    const int a = random.below(terms), b = random.below(terms), then = random.below(terms);
    if (first > second || !known.insert({first, second, a, b, then}).second) continue;
    list.push_back({{{model.inputs[static_cast<std::size_t>(first)].id, termId(a)},
                     {model.inputs[static_cast<std::size_t>(second)].id, termId(b)}},
                    termId(then)});
  }
  return model;
}

fuzzy::ForceModel modelWithInputs(int inputs) {
  constexpr int kTerms = 3;
  fuzzy::ForceModel model = evenModel(inputs, kTerms, 5);
  for (int i = 0; i < inputs; ++i) {
    const std::string next = "x" + std::to_string((i + 1) % inputs);
    for (int a = 0; a < kTerms; ++a) {
      for (int b = 0; b < kTerms; ++b) {
        fuzzy::Rule rule{{{"x" + std::to_string(i), termId(a)}}, termId(inputs == 1 ? a + b : (a + b + i) % 5)};
        if (inputs > 1) rule.conditions.push_back({next, termId(b)});
        model.experts[0].rules.push_back(std::move(rule));
      }
    }
  }
  return model;
}

Points randomPoints(const fuzzy::ForceModel& model, std::size_t count) {
  base::Random random(kCostSeed);
  Points points;
  std::vector<double> point(model.inputs.size());
  for (std::size_t p = 0; p < count; ++p) {
    for (std::size_t i = 0; i < point.size(); ++i) point[i] = random.uniform(model.inputs[i].min, model.inputs[i].max);
    points.add(point);
  }
  return points;
}

}  // namespace tactus::bench
