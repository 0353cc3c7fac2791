// Where a membership is above 0.
#pragma once

#include "core/fuzzy/membership.h"

namespace tactus::fuzzy {

/// The closed range outside which the membership is 0.
struct Support {
  double low = 0;
  double high = 0;
};

/// Of a trapezoid its feet; of a Gaussian where the exponential underflows, about 38.6 sigma from the mean, to the last
/// digit. There the Gaussian ends like a vertical edge: beyond, the evaluation finds that no rule fires.
Support supportOf(const MembershipFunction& function) noexcept;

}  // namespace tactus::fuzzy
