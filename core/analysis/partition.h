// A partition: terms whose memberships sum to one everywhere (Ruspini).
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

/// The terms of a list in their order on the universe, as indices.
using TermOrder = std::vector<std::size_t>;

/// The order by the middles of the cores (of a Gaussian, its mean); equal ones keep their order in the list.
TermOrder byMiddleOfCore(const std::vector<fuzzy::Term>& terms);

/// The order in which trapezoids and triangles sum to one on the universe of `variable`. The first term has membership
/// 1 at the lower end, each right edge is the left edge of the next term, and the last term has membership 1 at the
/// upper end. Nothing if the terms are no partition. Vertices count as equal within 1e-9 of the universe. Two terms
/// with one common vertical edge sum to one except at that point.
std::optional<TermOrder> partitionOrder(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms);

/// The narrowest ramp between two terms that sum to one, and the narrowest output term, as a share of the universe.
/// With a vertical edge both terms would have membership 1 at one point.
inline constexpr double kNarrowestShare = 1e-6;

}  // namespace tactus::analysis
