// What the inputs are to a hand: what it moves, and the conditions.
#pragma once

#include <QString>
#include <cstddef>
#include <optional>
#include <vector>

#include "app/figures/force_curves.h"
#include "app/workbench/model/open_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

/// Whether the hand moves this input: the way or the rate.
inline bool isMovedByHand(const fuzzy::Variable& input) noexcept {
  return fuzzy::roleOf(input) != fuzzy::Role::kCondition;
}

/// The middle of the part of the universe of `variable` in which `term` has membership 1.
double coreMiddle(const fuzzy::Variable& variable, const fuzzy::Term& term);

/// The part of the universe in which `term` has membership 0.5 or more; of width 0 if there is none.
figures::Interval halfRange(const fuzzy::Variable& variable, const fuzzy::Term& term);

/// The term with the largest membership at `value`; the first of equals. Nothing if `value` belongs to no term.
std::optional<std::size_t> strongestTerm(const fuzzy::Variable& variable, double value);

/// The poses of the first and the last word: their core middles.
struct EndPoses {
  double first = 0;
  double last = 0;
};
EndPoses endPoses(const fuzzy::Variable& pose);

}  // namespace tactus::workbench
