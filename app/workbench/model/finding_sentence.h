// One sentence for each finding about the rules, with the labels of the model: the same in the bench and in the labs.
#pragma once

#include <QString>

#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"
#include "elicitation/rules/rule_finding.h"

namespace tactus::workbench {

/// Names a rule by the item of the form behind it, or by its number if only the model is known. `finding` belongs to
/// `model`, and `compiled` is made from it. Thread: any.
QString findingSentence(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                        const elicitation::RuleFinding& finding);

}  // namespace tactus::workbench
