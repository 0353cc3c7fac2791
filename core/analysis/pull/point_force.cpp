#include "core/analysis/pull/point_force.h"

#include <algorithm>
#include <array>

#include "core/fuzzy/centroid.h"
#include "core/fuzzy/force_model.h"

namespace tactus::analysis {
namespace {

using fuzzy::ForceModel;
using fuzzy::MembershipFunction;

// Of the largest strength: what a word with less adds is lost in the rounding of the centroid. With Gaussian terms
// every rule fires a little.
constexpr double kLostInRounding = 1e-22;

std::size_t indexOf(const std::vector<fuzzy::Term>& terms, const std::string& id) {
  return static_cast<std::size_t>(findTerm(terms, id) - terms.data());
}

PointExpert pointExpert(const ForceModel& model, const fuzzy::Expert& expert, std::span<const double> point) {
  PointExpert out;
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    auto& list = out.memberships.emplace_back();
    for (const auto& term : termsFor(expert, model.inputs[i])) {
      list.push_back(MembershipFunction::of(term)(point[i]));
    }
  }
  const auto& words = termsFor(expert, model.output);
  for (const auto& word : words) out.words.push_back(MembershipFunction::of(word));
  out.strengths.assign(words.size(), 0);
  for (std::size_t r = 0; r < expert.rules.size(); ++r) {
    const fuzzy::Rule& rule = expert.rules[r];
    if (!fuzzy::takesPart(rule)) continue;
    PointRule resolved{r, {}, indexOf(words, rule.then), rule.weight, 1};
    for (const auto& condition : rule.conditions) {
      for (std::size_t i = 0; i < model.inputs.size(); ++i) {
        if (model.inputs[i].id != condition.input) continue;
        const std::size_t term = indexOf(termsFor(expert, model.inputs[i]), condition.term);
        resolved.conditions.push_back({i, term});
        resolved.membership = std::min(resolved.membership, out.memberships[i][term]);
      }
    }
    auto& strength = out.strengths[resolved.then];
    strength = std::max(strength, resolved.weight * resolved.membership);
    out.rules.push_back(std::move(resolved));
  }
  return out;
}

}  // namespace

PointForce::PointForce(const ForceModel& model, std::span<const double> point)
    : model_(model), point_(point.begin(), point.end()) {
  const std::vector<double> weights = normalizedWeights(model);
  for (const auto& expert : model.experts) {
    experts_.push_back(pointExpert(model, expert, point_));
    experts_.back().weight = weights[experts_.size() - 1];
    experts_.back().force_n = centroid(experts_.back().strengths, experts_.back().words);
  }
}

std::optional<double> PointForce::centroid(std::span<const double> strengths,
                                           std::span<const MembershipFunction> words) const {
  std::array<fuzzy::ActiveTerm, fuzzy::kMostTerms> active;
  std::size_t count = 0;
  double largest = 0;
  for (std::size_t w = 0; w < words.size(); ++w) largest = std::max(largest, strengths[w]);
  for (std::size_t w = 0; w < words.size(); ++w) {
    if (strengths[w] > kLostInRounding * largest) active[count++] = {&words[w], strengths[w], strengths[w]};
  }
  if (count == 0) return std::nullopt;
  for (std::size_t k = 0; k < count; ++k) active[k].height /= largest;
  const fuzzy::Variable& output = model_.output;
  return output.min + centroidOffset({active.data(), count}, model_.implication, output.min, output.max);
}

std::optional<double> PointForce::mean(std::span<const std::size_t> changed,
                                       std::span<const std::optional<double>> forces) const {
  double sum = 0;
  double weights = 0;
  std::size_t next = 0;
  for (std::size_t e = 0; e < experts_.size(); ++e) {
    const bool is_changed = next < changed.size() && changed[next] == e;
    const auto& force = is_changed ? forces[next++] : experts_[e].force_n;
    if (!force) continue;
    sum += experts_[e].weight * *force;
    weights += experts_[e].weight;
  }
  return weights > 0 ? std::optional(sum / weights) : std::nullopt;
}

std::optional<double> PointForce::withWords(std::span<const std::size_t> readers,
                                            std::span<const MembershipFunction> words) const {
  std::vector<std::optional<double>> forces;
  forces.reserve(readers.size());
  for (const std::size_t e : readers) forces.push_back(centroid(experts_[e].strengths, words));
  return mean(readers, forces);
}

std::optional<double> PointForce::withRule(std::size_t expert, std::size_t rule, std::size_t then,
                                           double weight) const {
  const PointExpert& one = experts_[expert];
  std::vector<double> strengths(one.words.size(), 0);
  for (std::size_t r = 0; r < one.rules.size(); ++r) {
    const PointRule& other = one.rules[r];
    auto& strength = strengths[r == rule ? then : other.then];
    strength = std::max(strength, (r == rule ? weight : other.weight) * other.membership);
  }
  // Most rules are weaker than another one with their word.
  const auto force = strengths == one.strengths ? one.force_n : centroid(strengths, one.words);
  return mean({&expert, 1}, {&force, 1});
}

MembershipProbe::MembershipProbe(const PointForce& point, const PulledList& list)
    : point_(point), reader_indices_(readersOf(point.model(), list)) {
  for (const std::size_t e : reader_indices_) {
    const PointExpert& expert = point.experts()[e];
    Reader& reader = readers_.emplace_back();
    reader.strengths.assign(expert.words.size(), 0);
    for (const PointRule& rule : expert.rules) {
      double rest = 1;
      std::optional<std::size_t> term;
      for (const auto& condition : rule.conditions) {
        if (condition.input == list.variable) {
          term = condition.term;
        } else {
          rest = std::min(rest, expert.memberships[condition.input][condition.term]);
        }
      }
      if (rest <= 0) continue;
      if (term) {
        reader.rules.push_back({*term, rule.then, rule.weight, rest});
      } else {
        reader.strengths[rule.then] = std::max(reader.strengths[rule.then], rule.weight * rest);
      }
    }
  }
}

std::optional<double> MembershipProbe::force(std::span<const double> memberships) const {
  std::vector<std::optional<double>> forces;
  forces.reserve(readers_.size());
  std::array<double, fuzzy::kMostTerms> strengths;
  for (std::size_t k = 0; k < readers_.size(); ++k) {
    const Reader& reader = readers_[k];
    std::copy(reader.strengths.begin(), reader.strengths.end(), strengths.begin());
    for (const Reader::Rule& rule : reader.rules) {
      auto& strength = strengths[rule.then];
      strength = std::max(strength, rule.weight * std::min(rule.rest, memberships[rule.term]));
    }
    forces.push_back(
        point_.centroid({strengths.data(), reader.strengths.size()}, point_.experts()[reader_indices_[k]].words));
  }
  return point_.mean(reader_indices_, forces);
}

std::vector<double> MembershipProbe::bends() const {
  constexpr std::size_t kMostPairs = 128;  // beyond them the even steps of a search must do
  std::vector<double> values;
  std::vector<double> weights = {1};
  const auto tidy = [](std::vector<double>& list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  };
  for (const Reader& reader : readers_) {
    values.insert(values.end(), reader.strengths.begin(), reader.strengths.end());
    for (const Reader::Rule& rule : reader.rules) {
      values.insert(values.end(), {rule.rest, rule.weight * rule.rest});
      weights.push_back(rule.weight);
    }
  }
  tidy(values);
  tidy(weights);
  if (values.size() * weights.size() > kMostPairs) weights = {1};
  if (values.size() > kMostPairs) values.clear();
  std::vector<double> out = {.5};
  for (const double value : values) {
    for (const double weight : weights) {
      const double at = value / weight;
      if (at > 0 && at < 1) out.insert(out.end(), {at, 1 - at});
    }
  }
  tidy(out);
  return out;
}

}  // namespace tactus::analysis
