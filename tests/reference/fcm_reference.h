// Fuzzy C-Means as the textbook has it, slow and obvious, in long double: the reference for tests and the benchmark.
#pragma once

#include <span>
#include <vector>

namespace tactus::reference {

/// Samples, their weights (none: all 1), and the fuzziness.
struct FcmProblem {
  std::span<const double> samples;
  std::span<const double> weights;
  double m = 2;
};

/// Memberships of x in the clusters (Bezdek 1981): 1 by the sum over l of (|x - v_k| / |x - v_l|)^(2/(m-1)); on centres
/// shared equally among the centres that lie there.
std::vector<long double> fcmMemberships(long double x, std::span<const long double> centres, double m);

/// J = sum of w u^m (x - v)^2 with those memberships.
long double fcmObjective(const FcmProblem& problem, std::span<const long double> centres);

struct FcmFixedPoint {
  std::vector<long double> centres;  ///< ascending
  int iterations = 0;
  bool stands_still = false;  ///< no centre moved by more than 1e-18 of the range of the samples
};

/// Bezdek's iteration from `centres`, memberships and centres in turn, until it stands still or `most` steps are done.
FcmFixedPoint fcmFixedPoint(const FcmProblem& problem, std::vector<long double> centres, int most);

}  // namespace tactus::reference
