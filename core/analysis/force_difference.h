// How far the averaged forces of two models over the same inputs are apart.
#pragma once

#include <optional>
#include <vector>

#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

struct ForceDifference {
  double largest_n = 0;    ///< largest |difference| seen
  std::vector<double> at;  ///< where; empty where no difference was seen
  double first_n = 0;      ///< forces of the two models there
  double second_n = 0;
  double rms_n = 0;                ///< over points spread evenly over the universes of the inputs
  std::size_t points = 0;          ///< points at which both fired, of both kinds
  std::size_t only_one_fires = 0;  ///< points at which one model has a force and the other has none
};

/// Looks at combinations of the vertices of the first model's terms and the middles between them for the largest
/// difference, and at evenly spread points for the root mean square; fewer where the models have many rules. Where one
/// model does not fire nothing is compared. `first` and `second` must be valid, with as many inputs each.
/// Deterministic.
ForceDifference forceDifference(const fuzzy::ForceModel& first, const fuzzy::CompiledModel& compiled_first,
                                const fuzzy::ForceModel& second, const fuzzy::CompiledModel& compiled_second);

}  // namespace tactus::analysis
