// Rules of another program with names turned into indices.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/exchange/import/foreign_model.h"

namespace tactus::exchange {

/// `variable is [not] term` by indices; the variable is an input in a condition, an output in a conclusion.
struct ResolvedLiteral {
  std::size_t variable = 0;
  std::size_t term = 0;
  bool negated = false;
  std::size_t at = 0;

  bool isSame(const ResolvedLiteral& other) const {
    return variable == other.variable && term == other.term && negated == other.negated;
  }
};

struct ResolvedRule {
  const ForeignRule* rule = nullptr;
  /// Without the literals that always hold, and without the alternatives that never do.
  std::vector<std::vector<ResolvedLiteral>> alternatives;
  std::vector<ResolvedLiteral> conclusions;
  std::optional<Word> reads_output;  ///< an output in the condition, which Tactus lacks; such literals are left out
};

/// All rules of the model. Refused: a variable or a term that the file does not define, a weight outside
/// [0, 1].
base::Result<std::vector<ResolvedRule>> resolved(const ForeignModel& model);

}  // namespace tactus::exchange
