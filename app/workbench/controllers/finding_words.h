// One sentence for each finding, in the labels of the model.
#pragma once

#include <QString>

#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"
#include "elicitation/rule_finding.h"

namespace tactus::workbench {

/// `finding` is one of `model`, and `compiled` made from it. Thread: any.
QString findingSentence(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                        const elicitation::RuleFinding& finding);

/// Whom the finding is about: `S1 and S4`, or `Mean`.
QString findingWho(const fuzzy::ForceModel& model, const elicitation::RuleFinding& finding);

/// The name of a hole, `depth 125 to 138 mm`, with the labels of the inputs in the place of their ids.
QString holeText(const fuzzy::ForceModel& model, const std::string& name);

/// The expert that the finding names first, or null where the mean is meant.
const fuzzy::Expert* expertOf(const fuzzy::ForceModel& model, const elicitation::RuleFinding& finding);

/// The input and the term of a place `depth oropharynx`; null where the place is no term of an input.
struct PlacedTerm {
  const fuzzy::Variable* input = nullptr;
  const fuzzy::Term* term = nullptr;
};
PlacedTerm termOfPlace(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, const std::string& place);

}  // namespace tactus::workbench
