// Whether the norms, the defuzzifier and the activation of a foreign model are those of Tactus.
#pragma once

#include <vector>

#include "core/exchange/import/foreign_model.h"
#include "core/exchange/import/resolved_rules.h"
#include "core/fuzzy/force_model.h"

namespace tactus::exchange {

/// Checks what `rules`, which all conclude on `output`, need: minimum for AND and maximum for OR where a rule uses
/// them, maximum as aggregation, the centroid, all rules active, one implication. Returns the implication. What FCL and
/// FIS do not state is the default of their programs, with a warning.
base::Result<fuzzy::Implication> checkMethods(const ForeignModel& model, const ForeignVariable& output,
                                              const std::vector<ResolvedRule>& rules);

}  // namespace tactus::exchange
