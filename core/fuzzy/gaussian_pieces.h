// The upper envelope of Gaussians and lines, and integrals over pieces of Gaussians.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/fuzzy/force_model.h"

namespace tactus::fuzzy {

/// Beyond this many sigmas exp(-u^2 / 2) is 0 in double precision.
constexpr double kGaussianReach = 39;

/// A set between two neighboring corners: a line, or a part of a Gaussian without an inflection point.
struct CurvePiece {
  bool curved;
  double x0, y0, slope;           ///< line through (x0, y0)
  double mean, sigma, log_scale;  ///< exp(log_scale - ((x - mean) / sigma)^2 / 2)

  double at(double x) const noexcept {
    if (!curved) return y0 + slope * (x - x0);
    const double u = (x - mean) / sigma;
    return std::exp(log_scale - 0.5 * u * u);
  }
  double slopeAt(double x) const noexcept { return curved ? -at(x) * (x - mean) / (sigma * sigma) : slope; }
};

/// Writes the crossings of `p` and `q` in (x0, x1), an interval between neighboring corners. There are at most two;
/// each is bracketed and, but for two lines, searched to the last bit. Returns the end of the written range.
/// Thread: any. Real-time safe: yes.
double* writeCrossings(const CurvePiece& p, const CurvePiece& q, double x0, double x1, double* out) noexcept;

/// Calls `visit(piece, from, to)` for each part of [x0, x1] in turn; `piece` is the highest one there.
/// `Piece` is CurvePiece or a type derived from it. `pieces`: at most kMostTerms, all between the same neighboring
/// corners.
/// If pieces coincide, the first one is visited, also where their heights differ by at most `same` of their size. A
/// part is empty only if x0 == x1 (corners that differ by less than an ulp). Thread: any. Real-time safe: yes, if
/// `visit` is.
template <class Piece, class Visit>
void walkHighestPieces(std::span<const Piece> pieces, double x0, double x1, double same, const Visit& visit) noexcept {
  if (pieces.empty()) return;
  // Two pieces cross at most twice.
  std::array<double, kMostTerms*(kMostTerms - 1) + 2> cuts;
  double* end = cuts.data();
  *end++ = x0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (std::size_t j = i + 1; j < pieces.size(); ++j) end = writeCrossings(pieces[i], pieces[j], x0, x1, end);
  }
  *end++ = x1;
  std::sort(cuts.data(), end);
  for (const double* cut = cuts.data() + 1; cut != end; ++cut) {
    const double from = cut[-1];
    const double to = *cut;
    if (from == to && end != cuts.data() + 2) continue;
    const double middle = from + (to - from) / 2;
    const Piece* top = pieces.data();
    for (const Piece& piece : pieces.subspan(1)) {
      if (piece.at(middle) > top->at(middle) * (1 + same)) top = &piece;
    }
    visit(*top, from, to);
  }
}

/// Replaces the area under a curved piece over [x0, x1] by point masses: calls `visit(x, mass)` for each. Uses
/// ten-point Gauss-Legendre quadrature on parts so short that its error is below rounding.
/// Thread: any. Real-time safe: yes, if `visit` is.
template <class Visit>
void visitGaussianMasses(const CurvePiece& piece, double x0, double x1, const Visit& visit) noexcept {
  // Gauss-Legendre nodes and weights on [-1, 1], ten points (Abramowitz and Stegun 1964, Table 25.4).
  constexpr std::array<double, 5> kNodes = {0.14887433898163122, 0.43339539412924719, 0.67940956829902441,
                                            0.86506336668898451, 0.97390652851717172};
  constexpr std::array<double, 5> kWeights = {0.29552422471475287, 0.26926671930999635, 0.21908636251598204,
                                              0.14945134915058059, 0.06667134430868814};
  for (double left = x0; left < x1;) {
    // On a part this short the integrand changes by less than a factor of e^5, and the rule's error is below 1e-16.
    const double distance = std::abs(left - piece.mean) / piece.sigma;
    const double right = std::min(x1, left + piece.sigma * 2 / (1 + distance));
    if (right <= left) return;
    const double half = (right - left) / 2;
    const double centre = left + half;
    for (std::size_t i = 0; i < kNodes.size(); ++i) {
      for (const double node : {-kNodes[i], kNodes[i]}) {
        const double x = centre + half * node;
        visit(x, half * kWeights[i] * piece.at(x));
      }
    }
    left = right;
  }
}

}  // namespace tactus::fuzzy
