// Random force models of the kind that people make: terms in their order, neighbors overlapping.
#pragma once

#include <vector>

#include "core/base/random.h"
#include "core/fuzzy/force_model.h"

namespace tactus::support {

/// A valid model: 1..4 inputs and an output of 2..6 ordered terms each, trapezoids and triangles, some with vertical
/// edges, the outermost ones ending at or beyond the universe; 1..4 experts, some with slightly moved terms of their
/// own, as an expert's own words would be; clip or scale; rules with 1 to all inputs. Mostly, but not always, the
/// output terms have a closed form.
fuzzy::ForceModel randomOrderedModel(base::Random& random);

/// A point in the universes, in one of ten inputs on a vertex of a term.
std::vector<double> randomOrderedPoint(base::Random& random, const fuzzy::ForceModel& model);

}  // namespace tactus::support
