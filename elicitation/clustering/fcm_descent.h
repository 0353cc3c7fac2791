// The descent from a start to a local minimum of J (part of fcm.h).
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
  bool minimum = false;  ///< J curves upward in every direction at the centers
  bool canceled = false;
};

/// The kind of the first step of a descent.
enum class FcmBeginning {
  kAnywhere,     ///< a step of Bezdek's iteration, which never raises J
  kNearMinimum,  ///< a Newton step
};

/// Called before each pass with the largest change of a center in the last step. False stops the descent.
using FcmBeforePass = std::function<bool(double change)>;

/// Descends from `centres` (distinct, ascending). The matrix of a step lies between J's second derivatives (Newton,
/// which reaches full precision) and the metric of Bezdek's iteration (which never raises J). Each rejected step moves
/// it towards Bezdek's. The descent ends if the estimated remaining distance is below settings.tolerance of the range
/// and, near a smooth minimum, below the rounding of the sums. The last step then needs no pass of its own.
FcmDescent descend(const FcmData& data, std::vector<double> centres, FcmBeginning beginning,
                   const FcmSettings& settings, const FcmBeforePass& before_pass);

}  // namespace tactus::elicitation
