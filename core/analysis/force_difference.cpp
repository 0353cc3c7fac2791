#include "core/analysis/force_difference.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "core/analysis/force_probe.h"
#include "core/analysis/sample_points.h"
#include "core/base/check.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/contracts/contract_check.h"

namespace tactus::analysis {
namespace {

using base::formatNumber;
using base::quoted;
using ChangeKind = ModelChange::Kind;

std::string text(const fuzzy::Term& term) {
  std::string out(name(term.shape));
  for (const double point : term.points) out += " " + formatNumber(point);
  return out;
}

std::string universe(const fuzzy::Variable& variable) {
  return formatNumber(variable.min) + " to " + formatNumber(variable.max) + " " + variable.unit;
}

/// What a rule concludes from its conditions.
std::string conclusion(const fuzzy::Rule& rule) {
  return rule.then + (rule.weight != 1 ? ", weight " + formatNumber(rule.weight) : "") +
         (rule.enabled ? "" : ", disabled");
}

/// Things in a fixed order, each under a name of its own.
class Listing {
 public:
  void add(std::string place, std::string content) { items_.emplace_back(std::move(place), std::move(content)); }

  void compare(const Listing& after, std::vector<ModelChange>& changes) const {
    std::map<std::string, std::string> others(after.items_.begin(), after.items_.end());
    for (const auto& [place, content] : items_) {
      const auto other = others.find(place);
      if (other == others.end()) {
        changes.push_back({ChangeKind::kRemoved, place, content, {}});
      } else if (other->second != content) {
        changes.push_back({ChangeKind::kChanged, place, content, other->second});
      }
    }
    const std::map<std::string, std::string> own(items_.begin(), items_.end());
    for (const auto& [place, content] : after.items_) {
      if (!own.contains(place)) changes.push_back({ChangeKind::kAdded, place, {}, content});
    }
  }

 private:
  std::vector<std::pair<std::string, std::string>> items_;
};

void addTerms(const std::vector<fuzzy::Term>& terms, const std::string& of, Listing& listing) {
  for (const fuzzy::Term& term : terms) listing.add("term " + quoted(term.id) + " of " + of, text(term));
}

void addVariable(const fuzzy::Variable& variable, Listing& listing) {
  listing.add("universe of " + quoted(variable.id), universe(variable));
  addTerms(variable.terms, quoted(variable.id), listing);
}

/// Rules by their conditions, sorted by input; a second rule with the same conditions is another one.
void addRules(const fuzzy::Expert& expert, Listing& listing) {
  std::map<std::string, int> seen;
  for (const fuzzy::Rule& rule : expert.rules) {
    std::vector<std::string> conditions;
    for (const fuzzy::Condition& condition : rule.conditions)
      conditions.push_back(condition.input + " " + condition.term);
    std::sort(conditions.begin(), conditions.end());
    std::string place = "rule of " + quoted(expert.id) + ": " + base::joined(conditions, ", ");
    if (const int copy = ++seen[place]; copy > 1) place += " (" + std::to_string(copy) + ")";
    listing.add(std::move(place), conclusion(rule));
  }
}

Listing listingOf(const fuzzy::ForceModel& model) {
  Listing listing;
  for (const fuzzy::Variable& input : model.inputs) addVariable(input, listing);
  addVariable(model.output, listing);
  listing.add("implication", std::string(name(model.implication)));
  listing.add("default force", formatNumber(model.default_force_n));
  for (const fuzzy::Expert& expert : model.experts) {
    listing.add("expert " + quoted(expert.id), "weight " + formatNumber(expert.weight));
    for (const fuzzy::TermOverride& own : expert.overrides) {
      addTerms(own.terms, quoted(own.variable) + " for " + quoted(expert.id), listing);
    }
    addRules(expert, listing);
  }
  for (const fuzzy::Contract& contract : model.contracts)
    listing.add("contract " + quoted(contract.id), contracts::sentenceOf(model, contract));
  for (const fuzzy::TubeEvent& event : model.events)
    listing.add("puncture at " + quoted(event.term), "share " + formatNumber(event.share));
  const fuzzy::RendererParameters renderer = model.renderer.value_or(fuzzy::RendererParameters{});
  for (const auto& field : fuzzy::kRendererFields) {
    listing.add(std::string("renderer, ") + field.key, formatNumber(renderer.*field.member));
  }
  return listing;
}

}  // namespace

std::string_view name(ModelChange::Kind kind) noexcept {
  constexpr std::string_view kNames[] = {"added", "removed", "changed"};
  return kNames[static_cast<int>(kind)];
}

std::vector<ModelChange> modelChanges(const fuzzy::ForceModel& first, const fuzzy::ForceModel& second) {
  std::vector<ModelChange> changes;
  listingOf(first).compare(listingOf(second), changes);
  return changes;
}

ForceRange reachableRange(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                          const std::stop_token& stop) {
  ForceProbe probe(model, compiled, std::numeric_limits<std::size_t>::max(), stop);
  const SamplePoints points = kinkPoints(model, affordablePoints(probe.costOfMean()));

  ForceRange range;
  SamplePoints::Choice lowest;
  SamplePoints::Choice highest;
  const auto look = [&](const SamplePoints::Choice& choice) -> std::optional<double> {
    ++range.points;
    const auto force = probe.mean(points.at(choice));
    if (!force.fired) return std::nullopt;
    if (range.fired == 0 || force.force_n < range.min_n) range.min_n = force.force_n, lowest = choice;
    if (range.fired == 0 || force.force_n > range.max_n) range.max_n = force.force_n, highest = choice;
    ++range.fired;
    return force.force_n;
  };
  for (std::size_t p = 0; p < points.size() && probe.affords(); ++p) look(points.choice(p));
  if (range.fired == 0) return range;
  points.climb(highest, range.max_n, look);
  points.climb(lowest, -range.min_n, [&](const SamplePoints::Choice& choice) -> std::optional<double> {
    const auto force = look(choice);
    return force ? std::optional(-*force) : std::nullopt;
  });
  return range;
}

std::vector<std::vector<double>> boxPoints(const fuzzy::ForceModel& model, std::size_t count) {
  std::vector<std::vector<double>> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < model.inputs.size(); ++k) {
      const auto& input = model.inputs[k];
      points[i].push_back(input.min + halton(i + 1, k) * (input.max - input.min));
    }
  }
  return points;
}

std::vector<std::vector<double>> linePoints(const fuzzy::ForceModel& model, const std::vector<double>& at,
                                            std::size_t input, std::size_t count) {
  const auto& variable = model.inputs[input];
  std::vector<std::vector<double>> points(count, at);
  for (std::size_t i = 0; i < count; ++i) {
    const double share = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0;
    points[i][input] = i + 1 == count ? variable.max : variable.min + share * (variable.max - variable.min);
  }
  return points;
}

ForceDifference forceDifference(const fuzzy::ForceModel& first, const fuzzy::CompiledModel& compiled_first,
                                const fuzzy::ForceModel& second, const fuzzy::CompiledModel& compiled_second) {
  TACTUS_CHECK(first.inputs.size() == second.inputs.size());
  constexpr std::size_t kUnbounded = std::numeric_limits<std::size_t>::max();
  ForceProbe one(first, compiled_first, kUnbounded);
  ForceProbe two(second, compiled_second, kUnbounded);
  const std::size_t most = affordablePoints(1 + one.costOfMean() + two.costOfMean());

  ForceDifference out;
  double squares = 0;
  std::size_t even_points = 0;
  const auto compare = [&](std::vector<double> point, bool counts_for_rms) {
    const auto a = one.mean(point);
    const auto b = two.mean(point);
    if (a.fired != b.fired) ++out.only_one_fires;
    if (!a.fired || !b.fired) return;
    ++out.points;
    const double newtons = std::abs(a.force_n - b.force_n);
    if (counts_for_rms) {
      squares += newtons * newtons;
      ++even_points;
    }
    if (newtons <= out.largest_n) return;
    out.largest_n = newtons;
    out.at = std::move(point);
    out.first_n = a.force_n;
    out.second_n = b.force_n;
  };
  const SamplePoints kinks = kinkPoints(first, most);
  for (std::size_t p = 0; p < kinks.size(); ++p) compare(kinks[p], false);
  const SamplePoints spread = evenPoints(first, most);
  for (std::size_t p = 0; p < spread.size(); ++p) compare(spread[p], true);
  if (even_points > 0) out.rms_n = std::sqrt(squares / static_cast<double>(even_points));
  return out;
}

}  // namespace tactus::analysis
