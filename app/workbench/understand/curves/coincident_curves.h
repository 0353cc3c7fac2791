// Finds curves of experts that lie on each other, so that none of them hides the others.
#pragma once

#include <cstddef>
#include <vector>

#include "app/figures/force_curves.h"

namespace tactus::workbench {

/// The place of a curve among those that it coincides with.
struct Coincidence {
  std::size_t member = 0;  ///< from 0
  std::size_t of = 1;      ///< how many lie on each other; 1: the curve is alone

  bool operator==(const Coincidence&) const = default;
};

/// One per expert. Two curves coincide where both fire and differ by at most `within_n`, if they do so over a tenth of
/// the axis or more. Of more than twelve experts none is looked at: their colors repeat anyway.
std::vector<Coincidence> coincidences(const figures::ForceCurves& curves, double within_n);

}  // namespace tactus::workbench
