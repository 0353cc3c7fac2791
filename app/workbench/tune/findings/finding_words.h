// One sentence for each finding, in the labels of the model.
#pragma once

#include <QString>

#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"
#include "elicitation/rules/rule_finding.h"

namespace tactus::workbench {

/// `finding` is one of `model`, and `compiled` made from it. Thread: any.
QString findingSentence(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                        const elicitation::RuleFinding& finding);

/// Whom the finding is about: `S1 and S4`, or `Mean`.
QString findingWho(const fuzzy::ForceModel& model, const elicitation::RuleFinding& finding);

/// A hole with the labels of its inputs: `Insertion depth 125 to 138 mm`.
QString holeText(const fuzzy::ForceModel& model, const analysis::Hole& hole);

/// The expert that the finding names first, or null where the mean is meant.
const fuzzy::Expert* expertOf(const fuzzy::ForceModel& model, const elicitation::RuleFinding& finding);

/// The variable and the term that a finding is about; null where it is about no term of its first expert.
struct PlacedTerm {
  const fuzzy::Variable* variable = nullptr;
  const fuzzy::Term* term = nullptr;
};
PlacedTerm termOfFinding(const fuzzy::ForceModel& model, const elicitation::RuleFinding& finding);

}  // namespace tactus::workbench
