// Polynomials of degree 6 through the values at the Chebyshev-Lobatto nodes of a stretch. Internal to the
// counterfactuals.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace tactus::analysis {

inline constexpr std::size_t kNodes = 7;

/// cos(pi (6 - j) / 6).
inline constexpr std::array<double, kNodes> kNodePlaces = {-1,  -0.86602540378443865, -0.5, 0,
                                                           0.5, 0.86602540378443865,  1};

/// Where a cubic is known: the nodes 0, 2, 4, 6.
inline constexpr std::array<double, 4> kCubicPlaces = {-1, -0.5, 0.5, 1};

/// The place of node `node` in [from, to]; the outer ones just within, as a limit is taken there.
inline double nodeAt(double from, double to, std::size_t node) {
  constexpr double kInside = 1e-9;
  const double share = std::clamp((1 + kNodePlaces[node]) / 2, kInside, 1 - kInside);
  return from + (to - from) * share;
}

/// Replaces the values at kNodePlaces by the coefficients of the polynomial through them, in
/// ascending powers of the place.
inline void toCoefficients(double* v) {
  // The even part is a cubic in the square of the place, the odd part a square times the place: divided differences.
  const double e0 = v[3], e1 = (v[4] + v[2]) / 2, e2 = (v[5] + v[1]) / 2, e3 = (v[6] + v[0]) / 2;
  const double e01 = (e1 - e0) * 4, e12 = (e2 - e1) * 2, e23 = (e3 - e2) * 4;
  const double e012 = (e12 - e01) / 0.75, e123 = (e23 - e12) / 0.75;
  const double e0123 = e123 - e012;
  const double o0 = v[4] - v[2], o1 = (v[5] - v[1]) / (2 * kNodePlaces[5]), o2 = (v[6] - v[0]) / 2;
  const double o01 = (o1 - o0) * 2, o12 = (o2 - o1) * 4;
  const double o012 = (o12 - o01) / 0.75;
  v[0] = e0;
  v[1] = o0 - o01 / 4 + o012 * 0.1875;
  v[2] = e01 - e012 / 4 + e0123 * 0.1875;
  v[3] = o01 - o012;
  v[4] = e012 - e0123;
  v[5] = o012;
  v[6] = e0123;
}

/// Weights of the values at kCubicPlaces in the cubic through them at `place` (Lagrange).
inline std::array<double, 4> cubicWeights(double place) {
  std::array<double, 4> out;
  for (std::size_t i = 0; i < 4; ++i) {
    out[i] = 1;
    for (std::size_t j = 0; j < 4; ++j) {
      if (j != i) out[i] *= (place - kCubicPlaces[j]) / (kCubicPlaces[i] - kCubicPlaces[j]);
    }
  }
  return out;
}

}  // namespace tactus::analysis
