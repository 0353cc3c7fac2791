#include "tests/support/ordered_model.h"

#include <algorithm>
#include <string>

namespace tactus::support {
namespace {

using base::Random;
using fuzzy::Shape;
using fuzzy::Term;
using fuzzy::Variable;

std::size_t below(Random& random, std::size_t count) {
  return static_cast<std::size_t>(random.below(static_cast<int>(count)));
}

/// Terms between knots: each falls where the next one rises, over a stretch that may be a point.
std::vector<Term> orderedTerms(Random& random, const Variable& v, int count) {
  const double cell = (v.max - v.min) / count;
  std::vector<Term> terms;
  double rise = v.min;
  double rise_end = random.below(3) == 0 ? v.min - cell * random.uniform() : v.min;
  rise = std::min(rise, rise_end);
  for (int k = 1; k <= count; ++k) {
    Term term{"t" + std::to_string(k), "Term " + std::to_string(k), Shape::kTrapezoid, {rise, rise_end, 0, 0}};
    const double knot = v.min + cell * k;
    double fall = knot - cell * random.uniform(0.05, 0.4);
    double fall_end = random.below(6) == 0 ? fall : knot + cell * random.uniform(-0.02, 0.3);
    if (k == count) fall = v.max + (random.below(3) == 0 ? cell * random.uniform() : 0), fall_end = fall;
    if (fall < rise_end) fall = rise_end;
    fall_end = std::max(fall_end, fall);
    term.points[2] = fall;
    term.points[3] = fall_end;
    if (random.below(6) == 0) {
      const double middle = (rise_end + fall) / 2;
      term.shape = Shape::kTriangle;
      term.points = {term.points[0], middle, term.points[3]};
    }
    terms.push_back(std::move(term));
    // The next one begins with this fall, or a little beside it.
    const bool aligned = random.below(2) == 0;
    rise = aligned ? fall : fall + cell * random.uniform(-0.04, 0.04);
    rise_end = aligned ? fall_end : std::max(rise, fall_end + cell * random.uniform(-0.04, 0.04));
  }
  return terms;
}

std::vector<Term> movedTerms(Random& random, const Variable& v) {
  std::vector<Term> terms = v.terms;
  for (Term& term : terms) {
    for (double& point : term.points) {
      if (point > v.min && point < v.max) point += random.uniform(-0.01, 0.01) * (v.max - v.min);
    }
    std::sort(term.points.begin(), term.points.end());
  }
  return terms;
}

Variable orderedVariable(Random& random, std::string id) {
  Variable v;
  v.label = id;
  v.id = std::move(id);
  v.unit = "1";
  v.min = random.below(2) == 0 ? 0 : random.uniform(-5, 5);
  v.max = v.min + random.uniform(0.1, 100);
  v.terms = orderedTerms(random, v, 2 + random.below(5));
  return v;
}

const std::string& anyTerm(Random& random, const Variable& v) { return v.terms[below(random, v.terms.size())].id; }

fuzzy::Expert anyExpert(Random& random, const fuzzy::ForceModel& model, int number) {
  fuzzy::Expert expert;
  expert.id = expert.label = "E" + std::to_string(number);
  expert.weight = random.below(3) == 0 ? random.uniform(0.2, 3) : 1;
  for (const Variable& input : model.inputs) {
    if (random.below(4) == 0) expert.overrides.push_back({input.id, movedTerms(random, input)});
  }
  if (random.below(4) == 0) expert.overrides.push_back({model.output.id, movedTerms(random, model.output)});
  const int rules = 4 + random.below(80);
  for (int r = 0; r < rules; ++r) {
    fuzzy::Rule rule;
    const std::size_t always = below(random, model.inputs.size());
    for (std::size_t i = 0; i < model.inputs.size(); ++i) {
      if (i == always || random.below(2) == 0)
        rule.conditions.push_back({model.inputs[i].id, anyTerm(random, model.inputs[i])});
    }
    if (random.below(2) == 0) std::reverse(rule.conditions.begin(), rule.conditions.end());
    rule.then = anyTerm(random, model.output);
    rule.weight = random.below(3) == 0 ? random.uniform(0.05, 1) : 1;
    rule.enabled = random.below(10) > 0;
    const auto same = [&rule](const fuzzy::Rule& other) {
      return other.then == rule.then && std::is_permutation(other.conditions.begin(), other.conditions.end(),
                                                            rule.conditions.begin(), rule.conditions.end());
    };
    if (std::none_of(expert.rules.begin(), expert.rules.end(), same)) expert.rules.push_back(std::move(rule));
  }
  return expert;
}

}  // namespace

fuzzy::ForceModel randomOrderedModel(Random& random) {
  fuzzy::ForceModel model;
  model.name = "random, ordered";
  model.created_utc = "2026-01-01T00:00:00Z";
  model.generator = "test";
  model.implication = random.below(2) == 0 ? fuzzy::Implication::kClip : fuzzy::Implication::kScale;
  const int inputs = 1 + random.below(4);
  for (int i = 0; i < inputs; ++i) model.inputs.push_back(orderedVariable(random, "x" + std::to_string(i)));
  model.output = orderedVariable(random, "y");
  const int experts = 1 + random.below(4);
  for (int e = 0; e < experts; ++e) model.experts.push_back(anyExpert(random, model, e));
  return model;
}

std::vector<double> randomOrderedPoint(Random& random, const fuzzy::ForceModel& model) {
  std::vector<double> point;
  for (const Variable& input : model.inputs) {
    const auto& vertices = input.terms[below(random, input.terms.size())].points;
    const bool on_vertex = random.below(10) == 0;
    point.push_back(on_vertex ? vertices[below(random, vertices.size())] : random.uniform(input.min, input.max));
  }
  return point;
}

}  // namespace tactus::support
