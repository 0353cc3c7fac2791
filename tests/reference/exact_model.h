// The slow, obvious evaluation of a force model in exact rational arithmetic. Only for tests.
#pragma once

#include <gmpxx.h>
#include <optional>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::reference {

/// Force of one expert at a point by the definitions of docs/semantics.md, exact; nothing where the expert abstains.
/// Trapezoids and triangles only.
std::optional<mpq_class> exactExpertForce(const fuzzy::ForceModel& model, std::size_t expert,
                                          const std::vector<double>& inputs);

/// Weighted mean over the experts that do not abstain (paper, Eq. 2), exact; nothing where all abstain.
std::optional<mpq_class> exactForce(const fuzzy::ForceModel& model, const std::vector<double>& inputs);

}  // namespace tactus::reference
