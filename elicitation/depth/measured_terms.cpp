#include "elicitation/depth/measured_terms.h"

#include <algorithm>

#include "core/base/text.h"

namespace tactus::elicitation {

std::string_view name(DepthsFrom from) noexcept { return from == DepthsFrom::kMeasured ? "measured" : "template"; }

base::Result<std::vector<fuzzy::Term>> measuredTerms(const DepthMeasurement& measurement, const fuzzy::Variable& depth,
                                                     const std::vector<fuzzy::Term>& set) {
  // All regions are checked first, so that an error names the same boundary whatever the form asks.
  if (auto all = depthTerms(depth, measurement.boundaries, measurement.scale); !all) return all;
  fuzzy::Variable some = depth;
  some.terms = set;
  std::vector<DepthBoundary> ends;
  for (std::size_t k = 0; k + 1 < set.size(); ++k) {
    const auto region = std::find_if(depth.terms.begin(), depth.terms.end(),
                                     [&](const fuzzy::Term& one) { return one.id == set[k].id; });
    const auto index = static_cast<std::size_t>(region - depth.terms.begin());
    if (index >= measurement.boundaries.size()) {
      return base::fail(base::ErrorCode::kReference, "depth terms", base::quoted(set[k].id),
                        "a region of the measurement with another one behind it");
    }
    ends.push_back(measurement.boundaries[index]);
  }
  return depthTerms(some, ends, measurement.scale);
}

std::string measuredSentence(const DepthMeasurement& measurement) {
  const std::string where = measurement.image.empty()
                                ? "typed, without an image"
                                : "measured on the image " + base::quoted(measurement.image) + " (" +
                                      base::roundedNumber(measurement.mm_per_px) + " mm per pixel" +
                                      (measurement.example ? ", a drawing, not a person" : "") + ")";
  return "The depths of the regions are " + where + ", anatomical scale " + base::roundedNumber(measurement.scale) +
         ".";
}

}  // namespace tactus::elicitation
