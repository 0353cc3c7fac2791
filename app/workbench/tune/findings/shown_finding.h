// A finding about the rules in the form for the screen: in words, with its place in the input space.
#pragma once

#include <QString>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"
#include "elicitation/rules/rule_lint.h"

namespace tactus::workbench {

/// The group of a finding. Kinds of one group share color and sign.
enum class FindingGroup {
  kCoverage,   ///< places without a force
  kConflict,   ///< contradictions between rules or experts
  kDirection,  ///< the force changes in the wrong direction, or too much at once
  kNeedless,   ///< rules and terms without effect
};

/// Whether a researcher accepted the finding.
enum class Acceptance {
  kNone,
  kAccepted,
  kLapsed,  ///< not a finding, but an acceptance whose hole no longer exists
};

/// A rule that a finding is about.
struct RuleOfExpert {
  std::string expert;    ///< id
  std::size_t rule = 0;  ///< index in Expert::rules

  bool operator==(const RuleOfExpert&) const = default;
};

struct ShownFinding {
  elicitation::RuleFinding finding;
  FindingGroup group = FindingGroup::kCoverage;
  QString kind;      ///< `Hole`
  QString who;       ///< `S1 and S4`, or `Mean`
  QString sentence;  ///< one sentence, with the labels of the model
  Acceptance acceptance = Acceptance::kNone;
  /// `Nasopharynx → Oropharynx` of a step between two neighboring terms; empty otherwise.
  QString step;
  /// The input along which it lies and the value there, to sort by place; nothing without a place.
  std::optional<std::pair<std::size_t, double>> along;
  std::vector<RuleOfExpert> rules;  ///< in the order of the sentence; empty if no rule is the cause
  /// The force at stake in just-noticeable differences around the force at its beginning; nothing if the force is not
  /// in newtons.
  std::optional<double> noticeable;
  /// Where to look at it, one value per input; nothing for an input that does not matter. Empty if it has no place.
  std::vector<std::optional<double>> at;
  std::vector<std::optional<double>> other_end;  ///< the beginning of the change of force; empty if the finding has one
                                                 ///< place
};

FindingGroup groupOf(elicitation::RuleFinding::Kind kind);

/// The findings of `lint`: largest force first, then those without a force, then accepted holes, then lapsed
/// acceptances. `lint` and `compiled` are made from `model`. Thread: any.
std::vector<ShownFinding> shownFindings(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                                        const elicitation::RuleLint& lint);

}  // namespace tactus::workbench
