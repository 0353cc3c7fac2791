#include "tests/reference/exact_gradient.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace tactus::reference {
namespace {

template <class List>
std::size_t indexOf(const List& list, const std::string& id) {
  std::size_t index = 0;
  while (list[index].id != id) ++index;
  return index;
}

/// The largest power of two that is at most x > 0.
mpq_class powerOfTwoBelow(const mpq_class& x) {
  const auto bits = [](const mpz_class& n) { return static_cast<long>(mpz_sizeinbase(n.get_mpz_t(), 2)); };
  const long exponent = bits(x.get_num()) - bits(x.get_den()) - 1;
  mpq_class power = 1;
  if (exponent >= 0) {
    power <<= static_cast<unsigned long>(exponent);
  } else {
    power >>= static_cast<unsigned long>(-exponent);
  }
  return power;
}

}  // namespace

mpq_class ExactGradient::Trapezoid::at(const mpq_class& x) const {
  if (x < a || x > d) return 0;
  if (x < b) return (x - a) / (b - a);
  if (x > c) return (d - x) / (d - c);
  return 1;
}

ExactGradient::ExactGradient(const fuzzy::ForceModel& model, const std::vector<double>& inputs)
    : clip_(model.implication == fuzzy::Implication::kClip) {
  std::vector<fuzzy::Variable> variables = model.inputs;
  variables.push_back(model.output);
  const auto add_bank = [this](const std::vector<fuzzy::Term>& terms) {
    std::vector<Trapezoid> bank;
    for (const auto& term : terms) {
      const auto& p = term.points;
      const bool triangle = term.shape == fuzzy::Shape::kTriangle;
      bank.push_back({p[0], p[1], triangle ? p[1] : p[2], triangle ? p[2] : p[3], triangle});
    }
    state_.banks.push_back(std::move(bank));
  };
  for (const auto& variable : variables) {
    min_.emplace_back(variable.min);
    max_.emplace_back(variable.max);
    add_bank(variable.terms);
  }
  for (const auto& expert : model.experts) {
    Expert made;
    made.weight = expert.weight;
    std::vector<std::size_t> own;
    for (std::size_t v = 0; v < variables.size(); ++v) {
      const auto& terms = fuzzy::termsFor(expert, v < model.inputs.size() ? model.inputs[v] : model.output);
      const bool shared = &terms == &(v < model.inputs.size() ? model.inputs[v] : model.output).terms;
      if (!shared) add_bank(terms);
      made.bank.push_back(shared ? v : state_.banks.size() - 1);
      own.push_back(shared ? 0 : made.bank.back());
    }
    for (const auto& rule : expert.rules) {
      Rule one;
      for (const auto& condition : rule.conditions) {
        const std::size_t input = indexOf(model.inputs, condition.input);
        one.conditions.emplace_back(input, indexOf(fuzzy::termsFor(expert, model.inputs[input]), condition.term));
      }
      one.then = indexOf(fuzzy::termsFor(expert, model.output), rule.then);
      one.weight = rule.weight;
      one.enabled = rule.enabled;
      made.rules.push_back(std::move(one));
    }
    own_bank_.push_back(std::move(own));
    state_.experts.push_back(std::move(made));
  }
  state_.inputs.assign(inputs.begin(), inputs.end());
  centroids_ = centroids(state_, nullptr, nullptr);
  for (std::size_t v = 0; v < variables.size(); ++v) smallest_.push_back(smallestDistance(state_, v));
  force_ = mean(centroids_);
}

bool ExactGradient::tied(double relative) const {
  const auto close = [&](std::vector<mpq_class> values) {
    std::sort(values.begin(), values.end());
    for (std::size_t k = 1; k < values.size(); ++k) {
      if (values[k - 1] > 0 && values[k] - values[k - 1] <= relative * values[k]) return true;
    }
    return false;
  };
  for (std::size_t e = 0; e < state_.experts.size(); ++e) {
    const Expert& expert = state_.experts[e];
    std::vector<std::vector<mpq_class>> of_term(centroids_[e].strengths.size());
    for (const auto& rule : expert.rules) {
      std::vector<mpq_class> memberships;
      for (const auto& [input, term] : rule.conditions) {
        const mpq_class x = std::clamp(state_.inputs[input], min_[input], max_[input]);
        memberships.push_back(state_.banks[expert.bank[input]][term].at(x));
      }
      if (close(memberships)) return true;
      const mpq_class smallest = *std::min_element(memberships.begin(), memberships.end());
      of_term[rule.then].push_back(rule.enabled ? mpq_class(rule.weight * smallest) : mpq_class(0));
    }
    if (std::any_of(of_term.begin(), of_term.end(), close) || close(centroids_[e].strengths)) return true;
  }
  return false;
}

std::vector<Parameter> ExactGradient::parameters() const {
  std::vector<Parameter> all;
  const std::size_t variables = min_.size();
  for (std::size_t v = 0; v + 1 < variables; ++v) all.push_back({Parameter::Kind::kInput, std::nullopt, v, 0, 0});
  const auto add_points = [&](std::optional<std::size_t> expert, std::size_t variable, std::size_t bank) {
    for (std::size_t t = 0; t < state_.banks[bank].size(); ++t) {
      const std::size_t points = state_.banks[bank][t].triangle ? 3 : 4;
      for (std::size_t p = 0; p < points; ++p) all.push_back({Parameter::Kind::kPoint, expert, variable, t, p});
    }
  };
  for (std::size_t v = 0; v < variables; ++v) add_points(std::nullopt, v, v);
  for (std::size_t e = 0; e < state_.experts.size(); ++e) {
    for (std::size_t v = 0; v < variables; ++v) {
      if (own_bank_[e][v] != 0) add_points(e, v, own_bank_[e][v]);
    }
    for (std::size_t r = 0; r < state_.experts[e].rules.size(); ++r) {
      all.push_back({Parameter::Kind::kWeight, e, 0, r, 0});
    }
  }
  return all;
}

std::size_t ExactGradient::bankOf(const Parameter& parameter) const {
  return parameter.expert ? own_bank_[*parameter.expert][parameter.variable] : parameter.variable;
}

bool ExactGradient::move(State& state, const Parameter& parameter, const mpq_class& by) const {
  if (parameter.kind == Parameter::Kind::kInput) {
    state.inputs[parameter.variable] += by;
    return true;
  }
  if (parameter.kind == Parameter::Kind::kWeight) {
    state.experts[*parameter.expert].rules[parameter.index].weight += by;
    return true;
  }
  Trapezoid& t = state.banks[bankOf(parameter)][parameter.index];
  if (t.triangle && parameter.point == 1) {
    t.b += by, t.c += by;
  } else {
    const std::size_t point = t.triangle && parameter.point == 2 ? 3 : parameter.point;
    *std::array{&t.a, &t.b, &t.c, &t.d}[point] += by;
  }
  return t.ordered();
}

mpq_class ExactGradient::smallestDistance(const State& state, std::size_t variable) const {
  std::vector<mpq_class> places = {min_[variable], max_[variable]};
  if (variable < state.inputs.size()) places.push_back(state.inputs[variable]);
  const auto add_bank = [&](const std::vector<Trapezoid>& bank) {
    for (const auto& t : bank) places.insert(places.end(), {t.a, t.b, t.c, t.d});
  };
  add_bank(state.banks[variable]);
  for (const auto& own : own_bank_) {
    if (own[variable] != 0) add_bank(state.banks[own[variable]]);
  }
  std::sort(places.begin(), places.end());
  mpq_class smallest = max_[variable] - min_[variable];
  for (std::size_t k = 1; k < places.size(); ++k) {
    if (places[k] > places[k - 1]) smallest = std::min(smallest, mpq_class(places[k] - places[k - 1]));
  }
  return smallest;
}

bool ExactGradient::concerns(const Parameter& parameter, std::size_t e) const {
  if (parameter.kind == Parameter::Kind::kInput) return true;
  if (parameter.kind == Parameter::Kind::kWeight) return parameter.expert == e;
  return state_.experts[e].bank[parameter.variable] == bankOf(parameter);
}

mpq_class ExactGradient::stepFor(const Parameter& parameter, const State& state,
                                 const std::vector<Centroid>& centroids) const {
  mpq_class smallest = 1;
  if (parameter.kind == Parameter::Kind::kWeight) {
    const auto& weight = state.experts[*parameter.expert].rules[parameter.index].weight;
    if (weight > 0) smallest = weight;
  } else {
    smallest = &state == &state_ ? smallest_[parameter.variable] : smallestDistance(state, parameter.variable);
  }
  // Clipping makes corners as close as the strengths are small.
  mpq_class strength = 1;
  for (const auto& centroid : centroids) {
    for (const auto& one : centroid.strengths) {
      if (one > 0) strength = std::min(strength, one);
    }
  }
  return powerOfTwoBelow(smallest * strength) >> 70;
}

std::vector<ExactGradient::Centroid> ExactGradient::centroids(const State& state, const Parameter* changed,
                                                              const std::vector<Centroid>* known) const {
  std::vector<Centroid> out(state.experts.size());
  const mpq_class& lo = min_.back();
  const mpq_class& hi = max_.back();
  std::vector<std::vector<mpq_class>> memberships(state.banks.size());
  const auto membershipsOf = [&](std::size_t input, std::size_t bank) -> const std::vector<mpq_class>& {
    if (memberships[bank].empty()) {
      const mpq_class x = std::clamp(state.inputs[input], min_[input], max_[input]);
      for (const auto& term : state.banks[bank]) memberships[bank].push_back(term.at(x));
    }
    return memberships[bank];
  };
  for (std::size_t e = 0; e < state.experts.size(); ++e) {
    const Expert& expert = state.experts[e];
    const auto& terms = state.banks[expert.bank.back()];
    Centroid& centroid = out[e];
    if (known != nullptr && !concerns(*changed, e)) {
      centroid = (*known)[e];
      continue;
    }
    centroid.strengths.resize(terms.size());
    for (const auto& rule : expert.rules) {
      if (!rule.enabled) continue;
      mpq_class strength = 1;
      for (const auto& [input, term] : rule.conditions) {
        strength = std::min(strength, membershipsOf(input, expert.bank[input])[term]);
        if (strength == 0) break;
      }
      if (strength == 0) continue;
      strength *= rule.weight;
      centroid.strengths[rule.then] = std::max(centroid.strengths[rule.then], strength);
    }
    centroid.fired = std::any_of(centroid.strengths.begin(), centroid.strengths.end(),
                                 [](const mpq_class& strength) { return strength > 0; });
    if (!centroid.fired) continue;
    const bool same_terms =
        known != nullptr && (changed->kind != Parameter::Kind::kPoint || changed->variable + 1 != min_.size());
    if (same_terms && (*known)[e].strengths == centroid.strengths) {
      centroid = (*known)[e];
      continue;
    }

    const auto height = [&](std::size_t t, const mpq_class& y) -> mpq_class {
      const mpq_class membership = terms[t].at(y);
      const mpq_class& strength = centroid.strengths[t];
      return clip_ ? std::min(strength, membership) : mpq_class(strength * membership);
    };
    std::vector<mpq_class> corners = {lo, hi};
    for (std::size_t t = 0; t < terms.size(); ++t) {
      const auto& f = terms[t];
      const mpq_class s = clip_ ? std::min(centroid.strengths[t], mpq_class(1)) : mpq_class(1);
      if (centroid.strengths[t] == 0) continue;
      for (const mpq_class& y : {f.a, mpq_class(f.a + s * (f.b - f.a)), mpq_class(f.d - s * (f.d - f.c)), f.d}) {
        if (y > lo && y < hi) corners.push_back(y);
      }
    }
    std::sort(corners.begin(), corners.end());

    // Between corners every set is a line: heights at a third and at two thirds give it.
    struct Line {
      mpq_class value, slope;
    };
    mpq_class moment = 0;
    for (std::size_t k = 1; k < corners.size(); ++k) {
      const mpq_class width = corners[k] - corners[k - 1];
      if (width == 0) continue;
      const mpq_class third = corners[k - 1] + width / 3;
      const mpq_class two_thirds = corners[k] - width / 3;
      std::vector<Line> lines;
      for (std::size_t t = 0; t < terms.size(); ++t) {
        if (centroid.strengths[t] == 0) continue;
        const mpq_class value = height(t, third);
        const mpq_class slope = (height(t, two_thirds) - value) * 3 / width;
        if (value != 0 || slope != 0) lines.push_back({value, slope});
      }
      std::vector<mpq_class> cuts = {corners[k - 1], corners[k]};
      for (std::size_t i = 0; i < lines.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          if (lines[i].slope == lines[j].slope) continue;
          const mpq_class y = third - (lines[i].value - lines[j].value) / (lines[i].slope - lines[j].slope);
          if (y > corners[k - 1] && y < corners[k]) cuts.push_back(y);
        }
      }
      std::sort(cuts.begin(), cuts.end());
      for (std::size_t c = 1; c < cuts.size(); ++c) {
        const mpq_class piece = cuts[c] - cuts[c - 1];
        if (piece == 0) continue;
        const mpq_class middle = cuts[c - 1] + piece / 2;
        mpq_class top = 0;
        mpq_class slope = 0;
        for (const auto& line : lines) {
          const mpq_class value = line.value + line.slope * (middle - third);
          if (value > top) top = value, slope = line.slope;
        }
        centroid.area += piece * top;
        moment += piece * top * middle + slope * piece * piece * piece / 12;
      }
    }
    centroid.force = moment / centroid.area;
  }
  return out;
}

std::optional<mpq_class> ExactGradient::mean(const std::vector<Centroid>& centroids) const {
  mpq_class weights = 0;
  mpq_class sum = 0;
  for (std::size_t e = 0; e < centroids.size(); ++e) {
    if (!centroids[e].fired || state_.experts[e].weight == 0) continue;
    weights += state_.experts[e].weight;
    sum += state_.experts[e].weight * centroids[e].force;
  }
  if (weights == 0) return std::nullopt;
  return mpq_class(sum / weights);
}

std::optional<ExactDerivative> ExactGradient::derivative(const Parameter& parameter, int direction,
                                                         double offset) const {
  State moved = state_;
  mpq_class step;
  std::vector<Centroid> beside;
  if (offset == 0) {
    step = stepFor(parameter, state_, centroids_);
  } else {
    if (!move(moved, parameter, mpq_class(offset))) return std::nullopt;
    beside = centroids(moved, &parameter, &centroids_);
    step = stepFor(parameter, moved, beside);
  }
  const auto& before = offset == 0 ? centroids_ : beside;
  if (!move(moved, parameter, step * direction)) return std::nullopt;
  const auto after = centroids(moved, &parameter, &before);

  const auto force = mean(before);
  const auto force_after = mean(after);
  if (!force || !force_after) return ExactDerivative{0, 0, force.has_value() != force_after.has_value()};
  mpq_class weights = 0;
  mpq_class scale = 0;
  for (std::size_t e = 0; e < before.size(); ++e) {
    if (!before[e].fired || !after[e].fired) continue;
    weights += state_.experts[e].weight;
    const mpq_class change = after[e].area - before[e].area;
    scale += state_.experts[e].weight * abs(change) / before[e].area;
  }
  if (weights > 0) scale *= (max_.back() - min_.back()) / (weights * step);
  const mpq_class change = *force_after - *force;
  const bool jump = abs(change) > (mpq_class(max_.back() - min_.back()) >> 40);
  return ExactDerivative{change / (step * direction), scale, jump};
}

}  // namespace tactus::reference
