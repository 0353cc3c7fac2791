// The difference between the averaged forces of two models with the same inputs.
#pragma once

#include <optional>
#include <vector>

#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

struct ForceDifference {
  double largest_n = 0;    ///< largest |difference| found
  std::vector<double> at;  ///< its point; empty if the forces are equal
  double first_n = 0;      ///< force of the first model there, then of the second
  double second_n = 0;
  double rms_n = 0;                ///< over points spread evenly over the universes of the inputs
  std::size_t points = 0;          ///< points of both kinds at which both models fired
  std::size_t only_one_fires = 0;  ///< points at which exactly one model fires
};

/// Searches the largest difference at combinations of the first model's vertices and midpoints, and the root mean
/// square at evenly spread points. Uses fewer points if the models have many rules. Skips points where one model does
/// not fire. `first` and `second`: valid, with the same number of inputs. Deterministic.
ForceDifference forceDifference(const fuzzy::ForceModel& first, const fuzzy::CompiledModel& compiled_first,
                                const fuzzy::ForceModel& second, const fuzzy::CompiledModel& compiled_second);

}  // namespace tactus::analysis
