// A term in another shape.
#pragma once

#include "app/editing/term_list.h"

namespace tactus::editing {

/// The term as a trapezoid, triangle or Gaussian that is 1/2 at the same two places: where two terms that sum to one
/// meet, so a region keeps its boundaries. Between trapezoid and triangle the area stays too. What is then left open:
///   triangle          the peak is the middle of the core (of a Gaussian its mean)
///   trapezoid         from a triangle the same function; from a Gaussian a core of half the width at 1/2
///   Gaussian          sigma = half the width at 1/2, divided by sqrt(2 ln 2)
/// A term that holds in full at one end of the universe [min, max] still does: it peaks there with a vertical edge
/// (Gaussian: its mean), and only its other place of 1/2 is kept. Refused: a Gaussian from a term without width.
base::Result<fuzzy::Term> converted(const fuzzy::Term& term, fuzzy::Shape shape, double min, double max);

/// The model with the term in that shape. Terms that summed to one need not do so afterwards.
base::Result<Edit> convertShape(const fuzzy::ForceModel& model, const TermPlace& place, fuzzy::Shape shape);

}  // namespace tactus::editing
