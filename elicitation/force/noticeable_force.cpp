#include "elicitation/force/noticeable_force.h"

#include <cmath>

namespace tactus::elicitation {

double justNoticeableDifference(double force_n) {
  constexpr double kThresholdN = 0.04;
  constexpr double kWeberFraction = 0.12;
  return std::hypot(kThresholdN, kWeberFraction * force_n);
}

}  // namespace tactus::elicitation
