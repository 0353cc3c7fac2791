// A finding about the rules as the screen shows it: in words, with its place in the space of the inputs.
#pragma once

#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"
#include "elicitation/rules/rule_lint.h"

namespace tactus::workbench {

/// What a finding is about; the kinds of one group share color and sign.
enum class FindingGroup {
  kCoverage,   ///< places without a force
  kConflict,   ///< rules or experts that contradict each other
  kDirection,  ///< the force goes the other way, or too far at once
  kNeedless,   ///< rules and terms that do nothing
};

/// Whether somebody said that it may stay.
enum class Acceptance {
  kNone,
  kAccepted,
  kLapsed,  ///< not a finding: an acceptance whose hole is gone
};

struct ShownFinding {
  elicitation::RuleFinding finding;
  FindingGroup group = FindingGroup::kCoverage;
  QString kind;      ///< `Hole`
  QString who;       ///< `S1 and S4`, or `Mean`
  QString sentence;  ///< one, with the labels of the model
  Acceptance acceptance = Acceptance::kNone;
  /// The force at stake in just-noticeable differences around the force at its beginning; nothing where the force is
  /// not in newtons.
  std::optional<double> noticeable;
  /// Where to look at it, one value per input; nothing for inputs that do not matter. Empty where there is no place.
  std::vector<std::optional<double>> at;
  std::vector<std::optional<double>> other_end;  ///< where the change of the force begins; empty where it has one place
};

FindingGroup groupOf(elicitation::RuleFinding::Kind kind);
/// `Hole`, `Mean jumps`, …
QString kindText(elicitation::RuleFinding::Kind kind);

/// The findings of `lint`, most newtons first, those without newtons after them, then accepted holes and at last
/// acceptances that lapsed. `lint` was made from `model`, `compiled` too. Thread: any.
std::vector<ShownFinding> shownFindings(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                                        const elicitation::RuleLint& lint);

}  // namespace tactus::workbench
