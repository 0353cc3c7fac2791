// Points spread over the whole input space, at which two models or two experts are compared.
#pragma once

#include <cstddef>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

/// Enough for a root mean square that no longer depends on the points in its third digit.
inline constexpr std::size_t kBoxPoints = 4'096;

/// `count` points of the Halton sequence (1960), from its first on, one value per input, scaled to the universes.
/// The same points for the same universes. They weigh the input space evenly, whatever is used of it in practice.
std::vector<std::vector<double>> boxPoints(const fuzzy::ForceModel& model, std::size_t count = kBoxPoints);

/// The points of one input's whole range, both ends included, with the other inputs at their values in `at`.
std::vector<std::vector<double>> linePoints(const fuzzy::ForceModel& model, const std::vector<double>& at,
                                            std::size_t input, std::size_t count);

}  // namespace tactus::analysis
