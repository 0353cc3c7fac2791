// A term in another shape, with its boundaries where they were.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

// The term with the largest membership of a value.

/// The index of the term of `variable` with the largest membership at `x`; the first of equals. `x`: in the unit of the
/// variable, not clamped to the universe. Nothing if all memberships are 0.
std::optional<std::size_t> strongestTerm(const fuzzy::Variable& variable, double x);

// A partition: terms whose memberships sum to one everywhere (Ruspini).

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

/// The term as a trapezoid, triangle or Gaussian with membership 1/2 at the same two places. Two terms of a partition
/// meet there, so a region keeps its boundaries. Between trapezoid and triangle the area also stays. The remaining
/// freedom:
///   triangle          the peak is the middle of the core (for a Gaussian its mean)
///   trapezoid         from a triangle the same function; from a Gaussian a core of half the width at 1/2
///   Gaussian          sigma = half the width at 1/2, divided by sqrt(2 ln 2)
/// A term with membership 1 at one end of the universe [min, max] keeps it: it peaks there with a vertical edge (a
/// Gaussian: with its mean), and only its other place of 1/2 is kept. Refused: a Gaussian from a term without width.
base::Result<fuzzy::Term> convertedTerm(const fuzzy::Term& term, fuzzy::Shape shape, double min, double max);

}  // namespace tactus::analysis
