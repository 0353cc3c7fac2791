// Invented nurses from one population, and studies of a few of them, to count how often a band holds the truth.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/random.h"
#include "core/study/records.h"
#include "elicitation/model/model_builder.h"

namespace tactus::stress {

/// A study of `people` nurses, each drawn independently: thresholds between the words, words of 45 rules around those
/// of S4, and ramps of the speed. No person's data.
struct InventedStudy {
  study::Study study;
  elicitation::BuiltModel built;  ///< with the nurses' ramps in the place of clustered strokes
  elicitation::BuildSettings settings;
};
InventedStudy inventedStudy(int people, elicitation::ForceTermsFrom force_terms, base::Random& random);

/// The points at which bands are checked: three of Fig. 11's curve and one of another setting.
std::vector<std::vector<double>> bandPoints();

/// The forces of that population at these points: the mean of studies of very many nurses.
std::vector<double> populationForces(elicitation::ForceTermsFrom force_terms);

}  // namespace tactus::stress
