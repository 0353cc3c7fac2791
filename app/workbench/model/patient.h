// What a nurse changes about tube and patient: lubrication and neck flexion, as inputs of the open model.
#pragma once

#include <QString>
#include <cstddef>
#include <optional>
#include <vector>

#include "app/workbench/model/force_curves.h"
#include "app/workbench/model/open_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

inline constexpr auto kLubricationId = "lubrication";
inline constexpr auto kNeckFlexionId = "neck_flexion";
inline constexpr auto kDepthId = "depth";
inline constexpr auto kSpeedId = "speed";

/// The middle of the part of `variable`'s universe that belongs fully to `term`.
double coreMiddle(const fuzzy::Variable& variable, const fuzzy::Term& term);

/// The part of the universe that belongs to `term` by half or more; of no width where there is none.
Interval halfRange(const fuzzy::Variable& variable, const fuzzy::Term& term);

/// The term that `value` belongs to most; the first of equals. Nothing where it belongs to none.
std::optional<std::size_t> strongestTerm(const fuzzy::Variable& variable, double value);

/// Neck flexion of a head held upright and of one flexed forward: the middle of its first and last term.
struct NeckPostures {
  double upright = 0;
  double flexed = 0;
};
/// Nothing: there are not two terms to choose from.
std::optional<NeckPostures> neckPostures(const fuzzy::Variable& neck_flexion);

}  // namespace tactus::workbench
