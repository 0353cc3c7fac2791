// The inputs that a nurse can change on tube and patient: lubrication and neck flexion.
#pragma once

#include <QString>
#include <cstddef>
#include <optional>
#include <vector>

#include "app/figures/force_curves.h"
#include "app/workbench/model/open_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

inline constexpr auto kLubricationId = "lubrication";
inline constexpr auto kNeckFlexionId = "neck_flexion";
inline constexpr auto kDepthId = "depth";
inline constexpr auto kSpeedId = "speed";

/// The middle of the part of the universe of `variable` in which `term` has membership 1.
double coreMiddle(const fuzzy::Variable& variable, const fuzzy::Term& term);

/// The part of the universe in which `term` has membership 0.5 or more; of width 0 if there is none.
figures::Interval halfRange(const fuzzy::Variable& variable, const fuzzy::Term& term);

/// The term with the largest membership at `value`; the first of equals. Nothing if `value` belongs to no term.
std::optional<std::size_t> strongestTerm(const fuzzy::Variable& variable, double value);

/// Neck flexion of an upright head and of a flexed one: the core middles of the first and the last term.
struct NeckPostures {
  double upright = 0;
  double flexed = 0;
};
/// Nothing if the variable has fewer than two terms.
std::optional<NeckPostures> neckPostures(const fuzzy::Variable& neck_flexion);

}  // namespace tactus::workbench
