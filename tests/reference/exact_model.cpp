#include "tests/reference/exact_model.h"

#include <algorithm>
#include <array>

namespace tactus::reference {
namespace {

using fuzzy::Term;

/// A trapezoid with rational vertices, clipped at or scaled by a strength.
struct Trapezoid {
  mpq_class a, b, c, d;

  explicit Trapezoid(const Term& term) {
    const auto& p = term.points;
    const bool triangle = term.shape == fuzzy::Shape::kTriangle;
    a = p[0], b = p[1], c = triangle ? p[1] : p[2], d = triangle ? p[2] : p[3];
  }

  mpq_class at(const mpq_class& x) const {
    if (x < a || x > d) return 0;
    if (x < b) return (x - a) / (b - a);
    if (x > c) return (d - x) / (d - c);
    return 1;
  }
};

struct ImpliedSet {
  Trapezoid shape;
  mpq_class strength;
  bool clip;

  mpq_class at(const mpq_class& x) const {
    const mpq_class membership = shape.at(x);
    return clip ? std::min(strength, membership) : mpq_class(strength * membership);
  }
};

/// A value between two ends, and the slope, of a function that is linear there.
struct LocalLine {
  mpq_class middle_value, slope;
};

LocalLine lineOn(const ImpliedSet& set, const mpq_class& x0, const mpq_class& x1) {
  const mpq_class middle = (x0 + x1) / 2;
  const mpq_class quarter = (x0 + middle) / 2;
  const mpq_class value = set.at(middle);
  return {value, (value - set.at(quarter)) / (middle - quarter)};
}

mpq_class centroid(const std::vector<ImpliedSet>& sets, const mpq_class& lo, const mpq_class& hi) {
  // All places where some set has a corner.
  std::vector<mpq_class> corners = {lo, hi};
  for (const auto& set : sets) {
    const auto& t = set.shape;
    const mpq_class rise = set.clip ? mpq_class(t.a + set.strength * (t.b - t.a)) : t.b;
    const mpq_class fall = set.clip ? mpq_class(t.d - set.strength * (t.d - t.c)) : t.c;
    for (const auto& x : {t.a, rise, fall, t.d}) {
      if (x > lo && x < hi) corners.push_back(x);
    }
  }
  std::sort(corners.begin(), corners.end());

  mpq_class area = 0;
  mpq_class moment = 0;
  for (std::size_t k = 1; k < corners.size(); ++k) {
    const mpq_class x0 = corners[k - 1];
    const mpq_class x1 = corners[k];
    if (x0 == x1) continue;
    const mpq_class middle = (x0 + x1) / 2;
    std::vector<LocalLine> lines;
    for (const auto& set : sets) lines.push_back(lineOn(set, x0, x1));

    std::vector<mpq_class> cuts = {x0, x1};
    for (std::size_t i = 0; i < lines.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (lines[i].slope == lines[j].slope) continue;
        const mpq_class x =
            middle - (lines[i].middle_value - lines[j].middle_value) / (lines[i].slope - lines[j].slope);
        if (x > x0 && x < x1) cuts.push_back(x);
      }
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t c = 1; c < cuts.size(); ++c) {
      const mpq_class left = cuts[c - 1];
      const mpq_class width = cuts[c] - left;
      const mpq_class centre = left + width / 2;
      mpq_class top = 0;
      mpq_class slope = 0;
      for (const auto& line : lines) {
        const mpq_class value = line.middle_value + line.slope * (centre - middle);
        if (value > top) top = value, slope = line.slope;
      }
      area += width * top;
      moment += width * top * centre + slope * width * width * width / 12;
    }
  }
  return moment / area;
}

const fuzzy::Variable& inputOf(const fuzzy::ForceModel& model, const std::string& id, std::size_t& index) {
  index = 0;
  while (model.inputs[index].id != id) ++index;
  return model.inputs[index];
}

mpq_class strengthOf(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, const fuzzy::Rule& rule,
                     const std::vector<double>& inputs) {
  mpq_class strength = 1;
  for (const auto& condition : rule.conditions) {
    std::size_t index = 0;
    const auto& variable = inputOf(model, condition.input, index);
    const mpq_class x = std::clamp(inputs[index], variable.min, variable.max);
    strength = std::min(strength, Trapezoid(*findTerm(termsFor(expert, variable), condition.term)).at(x));
  }
  return strength * mpq_class(rule.weight);
}

}  // namespace

std::optional<mpq_class> exactExpertForce(const fuzzy::ForceModel& model, std::size_t expert,
                                          const std::vector<double>& inputs) {
  const auto& who = model.experts[expert];
  const auto& terms = termsFor(who, model.output);
  std::vector<mpq_class> strengths(terms.size());
  for (const auto& rule : who.rules) {
    if (!rule.enabled) continue;
    const auto then = static_cast<std::size_t>(findTerm(terms, rule.then) - terms.data());
    strengths[then] = std::max(strengths[then], strengthOf(model, who, rule, inputs));
  }
  std::vector<ImpliedSet> sets;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    if (strengths[t] > 0) {
      sets.push_back({Trapezoid(terms[t]), strengths[t], model.implication == fuzzy::Implication::kClip});
    }
  }
  if (sets.empty()) return std::nullopt;
  return centroid(sets, model.output.min, model.output.max);
}

std::optional<mpq_class> exactForce(const fuzzy::ForceModel& model, const std::vector<double>& inputs) {
  mpq_class weights = 0;
  mpq_class sum = 0;
  for (std::size_t e = 0; e < model.experts.size(); ++e) {
    const mpq_class weight(model.experts[e].weight);
    if (weight == 0) continue;
    const auto force = exactExpertForce(model, e, inputs);
    if (!force) continue;
    weights += weight;
    sum += weight * *force;
  }
  if (weights == 0) return std::nullopt;
  return mpq_class(sum / weights);
}

}  // namespace tactus::reference
