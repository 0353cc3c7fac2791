// Centroid where Gaussian terms are among the active ones: crossings by bisection, pieces by quadrature.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/fuzzy/centroid.h"
#include "core/fuzzy/gaussian_pieces.h"

namespace tactus::fuzzy {
namespace {

// Keeps 0 * factor at 0 for strengths below the normal range.
constexpr double kLargestFactor = std::numeric_limits<double>::max();
// Corners per term: a trapezoid has 4, a Gaussian 2 ends, 2 inflections, 2 plateau ends and its mean.
constexpr std::size_t kMostCorners = 7 * kMostTerms + 2;

/// An implied set: height 1 is the largest strength.
struct ImpliedSet {
  const MembershipFunction* function;
  double top;     ///< height of the plateau
  double factor;  ///< height where the membership would be 1

  double at(double x) const noexcept { return std::min(top, (*function)(x)*factor); }
};

/// Corners of one implied set, between which it is a line, or a Gaussian without inflection.
std::size_t corners(const ActiveTerm& term, Implication implication, double* out) noexcept {
  const auto& f = *term.function;
  const double s = implication == Implication::kClip ? term.strength : 1;
  if (!f.gaussian) {
    out[0] = f.a, out[1] = f.a + s * (f.b - f.a), out[2] = f.d - s * (f.d - f.c), out[3] = f.d;
    return 4;
  }
  const double plateau = std::sqrt(-2 * std::log(s));
  std::size_t count = 0;
  for (const double u : {-kGaussianReach, -plateau, -1.0, 0.0, 1.0, plateau, kGaussianReach})
    out[count++] = f.mean + u * f.sigma;
  return count;
}

}  // namespace

double gaussianCentroidOffset(std::span<const ActiveTerm> terms, Implication implication, double lo,
                              double hi) noexcept {
  double largest = 0;
  for (const auto& term : terms) largest = std::max(largest, term.strength);

  std::array<ImpliedSet, kMostTerms> sets;
  std::array<double, kMostCorners> corner{};
  std::size_t corner_count = 0;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const double height = terms[i].height;
    sets[i] = {terms[i].function, height,
               implication == Implication::kClip ? std::min(1 / largest, kLargestFactor) : height};
    corner_count += corners(terms[i], implication, corner.data() + corner_count);
  }
  for (std::size_t k = 0; k < corner_count; ++k) corner[k] = std::clamp(corner[k], lo, hi);
  std::sort(corner.begin(), corner.begin() + static_cast<std::ptrdiff_t>(corner_count));

  const double origin = corner[0];
  AreaAndMoment sum;
  std::array<CurvePiece, kMostTerms> pieces;
  for (std::size_t k = 1; k < corner_count; ++k) {
    const double x0 = corner[k - 1];
    const double x1 = corner[k];
    if (x0 == x1) continue;
    std::size_t piece_count = 0;
    for (std::size_t i = 0; i < terms.size(); ++i) {
      const auto& f = *sets[i].function;
      const double middle = x0 + (x1 - x0) / 2;
      const bool outside = f.gaussian ? std::abs(middle - f.mean) > kGaussianReach * f.sigma : (x0 < f.a || x1 > f.d);
      if (outside) continue;
      const bool curved = f.gaussian && f(middle) * sets[i].factor < sets[i].top;
      const double y0 = sets[i].at(x0);
      const double slope = f.gaussian ? 0 : (sets[i].at(x1) - y0) / (x1 - x0);
      pieces[piece_count++] = {
          curved, x0, f.gaussian && !curved ? sets[i].top : y0, slope, f.mean, f.sigma, std::log(sets[i].factor)};
    }
    const std::span<const CurvePiece> found(pieces.data(), piece_count);
    walkHighestPieces(found, x0, x1, [&](const CurvePiece& top, double from, double to) {
      if (!top.curved) return sum.addLinear(from - origin, to - from, top.at(from), top.at(to));
      visitGaussianMasses(top, from, to, [&](double x, double mass) {
        sum.area += mass;
        sum.moment += mass * (x - origin);
      });
    });
  }
  return (origin - lo) + sum.moment / sum.area;
}

}  // namespace tactus::fuzzy
