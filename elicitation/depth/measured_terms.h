// Depth terms of a study whose regions were measured on an image: the boundaries of the measurement, the regions of the
// form.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "elicitation/depth/depth_measurement.h"

namespace tactus::elicitation {

/// Where the boundaries of the regions along the tube come from.
enum class DepthsFrom {
  kTemplate,  ///< the sets of elicitation/variables
  kMeasured,  ///< the study's measurement on an image
};

/// `template`, `measured`: the values of `tactus build --depths`.
std::string_view name(DepthsFrom from) noexcept;

/// The terms `set` with measured depths. `depth`: the depth with all regions, in the order of the measurement's
/// boundaries; `set` has some of them. A term ends at the end of its region; a region that `set` lacks belongs to the
/// term behind it, or at the end to the term before it, as in the sets of elicitation/variables.
/// Returns the errors of depthTerms.
base::Result<std::vector<fuzzy::Term>> measuredTerms(const DepthMeasurement& measurement, const fuzzy::Variable& depth,
                                                     const std::vector<fuzzy::Term>& set);

/// One sentence: on which image the depths were measured, at which scale.
std::string measuredSentence(const DepthMeasurement& measurement);

}  // namespace tactus::elicitation
