// A trapezoid for the tests of memberships and centroids.
#pragma once

#include "core/fuzzy/membership.h"

namespace tactus::fuzzy {

inline MembershipFunction trapezoid(double a, double b, double c, double d) {
  return MembershipFunction::of({"t", "t", Shape::kTrapezoid, {a, b, c, d}});
}

}  // namespace tactus::fuzzy
