#include "core/analysis/model_difference.h"

#include <algorithm>
#include <map>
#include <utility>

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

}  // namespace tactus::analysis
