// From a start downhill to a local minimum of J (part of fcm.h).
#pragma once

#include <vector>

#include "elicitation/fcm.h"
#include "elicitation/fcm_samples.h"

namespace tactus::elicitation {

struct FcmDescent {
  std::vector<double> centres;  ///< ascending
  double objective = 0;         ///< J
  int iterations = 0;
  bool converged = false;
  bool minimum = false;  ///< J curves upward in every direction there
};

/// Descends from `centres` (distinct) on values in [-1, 1]: steps of Bezdek's iteration, which never raise J, for the
/// first `warm_up` steps and wherever Newton's step does not lower J; Newton steps otherwise, which end at full
/// precision. Stops when a step moves no centre by more than settings.tolerance * range.
FcmDescent descend(const WeightedValues& data, std::vector<double> centres, double range, int warm_up,
                   const FcmSettings& settings);

}  // namespace tactus::elicitation
