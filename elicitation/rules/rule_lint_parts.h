// The parts of the rule lint and what they share. Internal to it.
#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/analysis/force_probe.h"
#include "elicitation/rules/rule_lint.h"

namespace tactus::elicitation {

/// A model with what the study knows of its rules.
struct RuleContext {
  const fuzzy::ForceModel& model;
  const fuzzy::CompiledModel& compiled;
  std::span<const ExpertRules> origins;  ///< one for each expert, or none
  const RuleLintSettings& settings;
  std::optional<std::size_t> region_input;

  /// Rule number `rule` of an expert with where it comes from.
  RuleFinding::Source source(std::size_t expert, std::size_t rule) const {
    return {rule, origins.empty() ? RuleOrigin{} : origins[expert].origins[rule]};
  }
  /// The items of an expert that give no rule.
  std::span<const MissingItem> missing(std::size_t expert) const {
    return origins.empty() ? std::span<const MissingItem>{} : std::span<const MissingItem>(origins[expert].missing);
  }
};

/// Index of the expert and of the two rules, of steps that a finding tells already.
using ToldSteps = std::set<std::pair<std::size_t, std::vector<std::size_t>>>;

// rule_lint_model.cpp
/// The findings of the lint of the model, with the rules and items that they are about; without those about `told`.
std::vector<RuleFinding> findingsOfModel(const RuleContext& context, const analysis::Lint& lint, const ToldSteps& told);
// rule_lint_steps.cpp
/// Steps against a declared direction, and jumps of levels between neighbouring answers; adds the former to `told`.
std::vector<RuleFinding> findingsOfSteps(const RuleContext& context, analysis::ForceProbe& probe, ToldSteps& told);
// rule_lint_cliffs.cpp
/// Steps of the force along an input, of the mean and of each expert. Nothing where the force is not in newtons.
std::vector<RuleFinding> findingsOfCliffs(const RuleContext& context, analysis::ForceProbe& probe);
// rule_lint_experts.cpp
/// Experts too far apart, by region. Nothing where the force is not in newtons.
std::vector<RuleFinding> findingsOfExperts(const RuleContext& context, analysis::ForceProbe& probe);

/// Says where a finding is, in both ways.
void setPlace(RuleFinding& finding, analysis::FindingPlace where, const fuzzy::ForceModel& model);

/// `0.525 N`
std::string newtonsText(double force_n);

/// Settings that each of `places` may look at within the time for all of them.
std::size_t settingsFor(const analysis::ForceProbe& probe, std::size_t places);

}  // namespace tactus::elicitation
