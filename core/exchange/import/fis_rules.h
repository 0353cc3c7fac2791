// The rules of a FIS file: `1 0 -2, 1 (0.5) : 1`, terms by their number.
#pragma once

#include <optional>

#include "core/exchange/import/foreign_model.h"

namespace tactus::exchange {

/// The rule in `line` for a model whose variables are complete. Refused: a number without a term, hedges, a rule
/// without condition or conclusion.
base::Result<ForeignRule> readFisRule(const ForeignModel& model, Word line);

}  // namespace tactus::exchange
