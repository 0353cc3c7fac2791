// From a start downhill to a local minimum of J (part of fcm.h).
#pragma once

#include <functional>
#include <vector>

#include "elicitation/clustering/fcm.h"
#include "elicitation/clustering/fcm_data.h"

namespace tactus::elicitation {

struct FcmDescent {
  std::vector<double> centres;  ///< ascending, scaled
  double objective = 0;         ///< J of the scaled data
  int iterations = 0;
  bool converged = false;
  bool minimum = false;  ///< J curves upward in every direction there
  bool cancelled = false;
};

/// Where a descent begins.
enum class FcmBeginning {
  kAnywhere,     ///< with a step of Bezdek's iteration, which never raises J
  kNearMinimum,  ///< with Newton's step
};

/// Called before each pass with the largest change of a centre so far; false stops the descent.
using FcmBeforePass = std::function<bool(double change)>;

/// Descends from `centres` (distinct, ascending) by steps of a matrix between J's second derivatives (Newton, which
/// ends at full precision) and the metric of Bezdek's iteration (which never raises J), the nearer to the latter the
/// more often a step had to be taken back. Ends where what remains is estimated to be below settings.tolerance of the
/// range and, near a smooth minimum, below the rounding of the sums; the last step needs no pass of its own then.
FcmDescent descend(const FcmData& data, std::vector<double> centres, FcmBeginning beginning,
                   const FcmSettings& settings, const FcmBeforePass& before_pass);

}  // namespace tactus::elicitation
