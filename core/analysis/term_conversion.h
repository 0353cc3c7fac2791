// A term in another shape, with its boundaries where they were.
#pragma once

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

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
