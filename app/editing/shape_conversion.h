// Converts a term to another shape.
#pragma once

#include "app/editing/term_list.h"

namespace tactus::editing {

/// The term as a trapezoid, triangle or Gaussian with membership 1/2 at the same two places. Two terms of a partition
/// meet there, so a region keeps its boundaries. Between trapezoid and triangle the area also stays. The remaining
/// freedom:
///   triangle          the peak is the middle of the core (for a Gaussian its mean)
///   trapezoid         from a triangle the same function; from a Gaussian a core of half the width at 1/2
///   Gaussian          sigma = half the width at 1/2, divided by sqrt(2 ln 2)
/// A term with membership 1 at one end of the universe [min, max] keeps it: it peaks there with a vertical edge (a
/// Gaussian: with its mean), and only its other place of 1/2 is kept. Refused: a Gaussian from a term without width.
base::Result<fuzzy::Term> converted(const fuzzy::Term& term, fuzzy::Shape shape, double min, double max);

/// The model with the converted term. Terms that summed to one may no longer do so.
base::Result<Edit> convertShape(const fuzzy::ForceModel& model, const TermPlace& place, fuzzy::Shape shape);

}  // namespace tactus::editing
