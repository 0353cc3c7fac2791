// Centroid where Gaussian terms are among the active ones: crossings by bisection, pieces by quadrature.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/fuzzy/centroid.h"

namespace tactus::fuzzy {
namespace {

// Beyond this many sigmas exp(-u^2 / 2) is 0 in double precision.
constexpr double kReach = 39;
// Keeps 0 * factor at 0 for strengths below the normal range.
constexpr double kLargestFactor = std::numeric_limits<double>::max();
// Corners per term: a trapezoid has 4, a Gaussian 2 ends, 2 inflections, 2 plateau ends and its mean.
constexpr std::size_t kMostCorners = 7 * kMostTerms + 2;
// Two terms cross at most twice between neighbouring corners.
constexpr std::size_t kMostCrossings = kMostTerms * (kMostTerms - 1);

/// An implied set: height 1 is the largest strength.
struct ImpliedSet {
  const MembershipFunction* function;
  double top;     ///< height of the plateau
  double factor;  ///< height where the membership would be 1

  double at(double x) const noexcept { return std::min(top, (*function)(x)*factor); }
};

/// What an implied set is between two neighbouring corners.
struct Piece {
  bool gaussian;
  double x0, y0, slope;           ///< line through (x0, y0)
  double mean, sigma, log_scale;  ///< exp(log_scale - ((x - mean) / sigma)^2 / 2)

  double at(double x) const noexcept {
    if (!gaussian) return y0 + slope * (x - x0);
    const double u = (x - mean) / sigma;
    return std::exp(log_scale - 0.5 * u * u);
  }
  double slopeAt(double x) const noexcept { return gaussian ? -at(x) * (x - mean) / (sigma * sigma) : slope; }
};

/// A point in [left, right] where `f` changes its sign, to the last bit; f(left) and f(right) differ in sign.
template <class F>
double bisect(const F& f, double left, double right) noexcept {
  const bool rising = f(left) <= 0;
  while (true) {
    const double middle = left + (right - left) / 2;
    if (middle <= left || middle >= right) return middle;
    ((f(middle) <= 0) == rising ? left : right) = middle;
  }
}

/// Where `p` and `q` cross in (x0, x1), between neighbouring corners: at most two points.
std::size_t crossings(const Piece& p, const Piece& q, double x0, double x1, std::array<double, 2>& out) noexcept {
  // The logarithm has the sign of the difference, and between two Gaussians it is a parabola.
  const bool both = p.gaussian && q.gaussian;
  const auto difference = [&](double x) {
    if (!both) return p.at(x) - q.at(x);
    const double u = (x - p.mean) / p.sigma;
    const double v = (x - q.mean) / q.sigma;
    return (p.log_scale - q.log_scale) - 0.5 * (u - v) * (u + v);
  };
  // Split at the extremum of the difference, so that each part holds at most one crossing.
  double middle = x1;
  if (both) {
    const double pp = 1 / (p.sigma * p.sigma);
    const double qq = 1 / (q.sigma * q.sigma);
    if (pp != qq) middle = (p.mean * pp - q.mean * qq) / (pp - qq);
  } else {
    const auto slope = [&](double x) { return p.slopeAt(x) - q.slopeAt(x); };
    if ((slope(x0) <= 0) != (slope(x1) <= 0)) middle = bisect(slope, x0, x1);
  }
  middle = middle > x0 && middle < x1 ? middle : x1;

  std::size_t count = 0;
  for (const auto& [left, right] : {std::pair{x0, middle}, std::pair{middle, x1}}) {
    if (left < right && (difference(left) <= 0) != (difference(right) <= 0))
      out[count++] = bisect(difference, left, right);
  }
  return count;
}

/// Adds a Gaussian piece over [x0, x1], positions measured from `origin`.
void addGaussian(const Piece& piece, double x0, double x1, double origin, AreaAndMoment& sum) noexcept {
  // Gauss-Legendre nodes and weights on [-1, 1], ten points (Abramowitz and Stegun 1964, Table 25.4).
  constexpr std::array<double, 5> kNodes = {0.14887433898163122, 0.43339539412924719, 0.67940956829902441,
                                            0.86506336668898451, 0.97390652851717172};
  constexpr std::array<double, 5> kWeights = {0.29552422471475287, 0.26926671930999635, 0.21908636251598204,
                                              0.14945134915058059, 0.06667134430868814};
  for (double left = x0; left < x1;) {
    // On a part this short the integrand changes by less than a factor of e^5, and the rule's error is below 1e-16.
    const double u = std::abs(left - piece.mean) / piece.sigma;
    const double right = std::min(x1, left + piece.sigma * 2 / (1 + u));
    if (right <= left) return;
    const double half = (right - left) / 2;
    const double centre = left + half;
    for (std::size_t i = 0; i < kNodes.size(); ++i) {
      for (const double node : {-kNodes[i], kNodes[i]}) {
        const double x = centre + half * node;
        const double mass = half * kWeights[i] * piece.at(x);
        sum.area += mass;
        sum.moment += mass * (x - origin);
      }
    }
    left = right;
  }
}

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
  for (const double u : {-kReach, -plateau, -1.0, 0.0, 1.0, plateau, kReach}) out[count++] = f.mean + u * f.sigma;
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
  std::array<Piece, kMostTerms> pieces;
  std::array<double, kMostCrossings + 2> cuts;
  for (std::size_t k = 1; k < corner_count; ++k) {
    const double x0 = corner[k - 1];
    const double x1 = corner[k];
    if (x0 == x1) continue;
    std::size_t piece_count = 0;
    for (std::size_t i = 0; i < terms.size(); ++i) {
      const auto& f = *sets[i].function;
      const double middle = x0 + (x1 - x0) / 2;
      const bool outside = f.gaussian ? std::abs(middle - f.mean) > kReach * f.sigma : (x0 < f.a || x1 > f.d);
      if (outside) continue;
      const bool curved = f.gaussian && f(middle) * sets[i].factor < sets[i].top;
      const double y0 = sets[i].at(x0);
      const double slope = f.gaussian ? 0 : (sets[i].at(x1) - y0) / (x1 - x0);
      pieces[piece_count++] = {
          curved, x0, f.gaussian && !curved ? sets[i].top : y0, slope, f.mean, f.sigma, std::log(sets[i].factor)};
    }
    if (piece_count == 0) continue;

    std::size_t cut_count = 0;
    cuts[cut_count++] = x0;
    for (std::size_t i = 0; i < piece_count; ++i) {
      for (std::size_t j = i + 1; j < piece_count; ++j) {
        std::array<double, 2> found{};
        const std::size_t count = crossings(pieces[i], pieces[j], x0, x1, found);
        for (std::size_t c = 0; c < count; ++c) cuts[cut_count++] = found[c];
      }
    }
    cuts[cut_count++] = x1;
    std::sort(cuts.begin(), cuts.begin() + static_cast<std::ptrdiff_t>(cut_count));
    for (std::size_t c = 1; c < cut_count; ++c) {
      if (cuts[c - 1] == cuts[c]) continue;
      const double middle = cuts[c - 1] + (cuts[c] - cuts[c - 1]) / 2;
      const Piece* top = pieces.data();
      for (std::size_t i = 1; i < piece_count; ++i) {
        if (pieces[i].at(middle) > top->at(middle)) top = &pieces[i];
      }
      if (top->gaussian) {
        addGaussian(*top, cuts[c - 1], cuts[c], origin, sum);
      } else {
        sum.addLinear(cuts[c - 1] - origin, cuts[c] - cuts[c - 1], top->at(cuts[c - 1]), top->at(cuts[c]));
      }
    }
  }
  return (origin - lo) + sum.moment / sum.area;
}

}  // namespace tactus::fuzzy
