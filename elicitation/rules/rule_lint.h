// Findings about the rules of a model, using the study's data: items, table lines, declared directions.
#pragma once

#include <optional>
#include <set>
#include <span>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "core/analysis/directions.h"
#include "core/analysis/force_probe.h"
#include "core/analysis/lint.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"
#include "elicitation/rules/expert_rules.h"
#include "elicitation/rules/rule_finding.h"

namespace tactus::elicitation {

/// The declared direction of the force for a growing input. No law: it follows what most experts say.
struct DeclaredDirection {
  std::string input;
  analysis::Direction direction = analysis::Direction::kMixed;  ///< kMixed declares nothing

  bool operator==(const DeclaredDirection&) const = default;
};

/// The directions that the procedure of `model` declares (its provenance).
std::vector<DeclaredDirection> declaredDirections(const fuzzy::ForceModel& model);

/// The limits for findings. Inputs that the model lacks are ignored.
struct RuleLintSettings {
  std::optional<std::vector<DeclaredDirection>> directions;  ///< nothing: those of the model's procedure
  std::optional<std::string> region_input;                   ///< nothing: the way; empty: no regions
  int jump_levels = 3;                                       ///< levels between neighboring answers that make a finding
  double noticeable_times = 2;  ///< just-noticeable differences between experts that make a finding
};

struct RuleLint {
  std::vector<RuleFinding>
      findings;                  ///< by kind in the order of RuleFinding::Kind, within a kind the largest newtons first
  analysis::Lint model;          ///< reachable range, bounds, completeness; `findings` includes its findings
  bool newtons_complete = true;  ///< false if the budget for forces was used up (huge model)
};

/// All findings about `model`, which must be valid. `compiled`: made from it. `origins`: one per expert in the model's
/// order (BuiltModel::experts), or none if only the model is known; then there are no missing items, and rules are
/// named by number. Experts are compared only if the force is in N. Ends soon after `stop` is requested; the result is
/// then invalid.
RuleLint ruleLint(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                  std::span<const ExpertRules> origins = {}, const RuleLintSettings& settings = {},
                  const std::stop_token& stop = {});

// The parts of the rule lint, and their shared data. Internal to the rule lint.

/// A model and the study's data about its rules.
struct RuleContext {
  const fuzzy::ForceModel& model;
  const fuzzy::CompiledModel& compiled;
  std::span<const ExpertRules> origins;  ///< one per expert, or none
  const RuleLintSettings& settings;
  std::vector<DeclaredDirection> directions;
  std::optional<std::size_t> region_input;

  /// Rule number `rule` of an expert, with its origin.
  RuleFinding::Source source(std::size_t expert, std::size_t rule) const {
    return {rule, origins.empty() ? RuleOrigin{} : origins[expert].origins[rule]};
  }
  /// The items of an expert without a rule.
  std::span<const MissingItem> missing(std::size_t expert) const {
    return origins.empty() ? std::span<const MissingItem>{} : std::span<const MissingItem>(origins[expert].missing);
  }
};

/// Expert index and rule indices of the steps already reported.
using ToldSteps = std::set<std::pair<std::size_t, std::vector<std::size_t>>>;

// rule_lint.cpp
/// The findings of the model's lint, with their rules and items; without the steps in `told`.
std::vector<RuleFinding> findingsOfModel(const RuleContext& context, const analysis::Lint& lint, const ToldSteps& told);
// rule_lint.cpp
/// Steps against a declared direction, and jumps of levels between neighboring answers. Adds the former to `told`.
std::vector<RuleFinding> findingsOfSteps(const RuleContext& context, analysis::ForceProbe& probe, ToldSteps& told);
// rule_lint.cpp
/// Steps of the force along an input, of the mean and of each expert. None if the force is not in N.
std::vector<RuleFinding> findingsOfCliffs(const RuleContext& context, analysis::ForceProbe& probe);
// rule_lint.cpp
/// Experts too far apart, by region. None if the force is not in N.
std::vector<RuleFinding> findingsOfExperts(const RuleContext& context, analysis::ForceProbe& probe);

/// Sets the place of a finding, as data and in words.
void setPlace(RuleFinding& finding, analysis::FindingPlace where, const fuzzy::ForceModel& model);

/// `0.525 N`
std::string newtonsText(double force_n);

/// The number of settings that each of `places` searches may try within the common budget.
std::size_t settingsFor(const analysis::ForceProbe& probe, std::size_t places);

}  // namespace tactus::elicitation
