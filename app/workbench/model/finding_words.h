// What a finding about the rules is called, and whom and what it is about, with the labels of the model.
#pragma once

#include <QString>

#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"
#include "elicitation/rules/rule_finding.h"

namespace tactus::workbench {

// One sentence for each finding about the rules, with the labels of the model: the same in the bench and in the labs.

/// Names a rule by the item of the form behind it, or by its number if only the model is known. `finding` belongs to
/// `model`, and `compiled` is made from it. Thread: any.
QString findingSentence(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                        const elicitation::RuleFinding& finding);

/// `Hole`, `Mean jumps`, …
QString kindText(elicitation::RuleFinding::Kind kind);

/// The experts of the finding: `S1 and S4`, or `Mean`.
QString findingWho(const fuzzy::ForceModel& model, const elicitation::RuleFinding& finding);

/// A hole with the labels of its inputs: `Insertion depth 125 to 138 mm`.
QString holeText(const fuzzy::ForceModel& model, const analysis::Hole& hole);

/// The first expert of the finding; null if it concerns the mean.
const fuzzy::Expert* expertOf(const fuzzy::ForceModel& model, const elicitation::RuleFinding& finding);

/// The variable and the term of a finding; null if it concerns no term of its first expert.
struct PlacedTerm {
  const fuzzy::Variable* variable = nullptr;
  const fuzzy::Term* term = nullptr;
};
PlacedTerm termOfFinding(const fuzzy::ForceModel& model, const elicitation::RuleFinding& finding);

}  // namespace tactus::workbench
