// The sweep over output sets with Gaussians: crossings by bisection, pieces by quadrature.
#include <algorithm>
#include <cmath>

#include "core/analysis/gradient_sets.h"

namespace tactus::analysis {
namespace {

using fuzzy::kMostTerms;

/// What a set is between two neighbouring corners: a line, or a Gaussian without inflection.
struct Piece {
  bool curved;
  Line line;
  double x0, slope;               ///< of the line
  double mean, sigma, log_scale;  ///< exp(log_scale - ((x - mean) / sigma)^2 / 2)

  double at(double x) const noexcept {
    if (!curved) return line.y0 + slope * (x - x0);
    const double u = (x - mean) / sigma;
    return std::exp(log_scale - 0.5 * u * u);
  }
  double slopeAt(double x) const noexcept { return curved ? -at(x) * (x - mean) / (sigma * sigma) : slope; }
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

/// Where `p` and `q` cross in (x0, x1): at most two points, appended to `out`.
double* addCrossings(const Piece& p, const Piece& q, double x0, double x1, double* out) noexcept {
  // Between two Gaussians the logarithm of the quotient has the sign of the difference, and is a parabola.
  const bool both = p.curved && q.curved;
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
  for (const auto& [left, right] : {std::pair{x0, middle}, std::pair{middle, x1}}) {
    if (left < right && (difference(left) <= 0) != (difference(right) <= 0)) *out++ = bisect(difference, left, right);
  }
  return out;
}

void addGaussian(const Piece& piece, double x0, double x1, double origin, GradientSums& sums) noexcept {
  // Gauss-Legendre nodes and weights on [-1, 1], ten points (Abramowitz and Stegun 1964, Table 25.4).
  constexpr std::array<double, 5> kNodes = {0.14887433898163122, 0.43339539412924719, 0.67940956829902441,
                                            0.86506336668898451, 0.97390652851717172};
  constexpr std::array<double, 5> kWeights = {0.29552422471475287, 0.26926671930999635, 0.21908636251598204,
                                              0.14945134915058059, 0.06667134430868814};
  for (double left = x0; left < x1;) {
    // On a part this short the integrand changes by less than a factor of e^5 and the rule's error is below rounding.
    const double distance = std::abs(left - piece.mean) / piece.sigma;
    const double right = std::min(x1, left + piece.sigma * 2 / (1 + distance));
    if (right <= left) return;
    const double half = (right - left) / 2;
    const double centre = left + half;
    for (std::size_t i = 0; i < kNodes.size(); ++i) {
      for (const double node : {-kNodes[i], kNodes[i]}) {
        const double x = centre + half * node;
        sums.addGaussianMass(piece.line.set, x - origin, half * kWeights[i] * piece.at(x),
                             (x - piece.mean) / piece.sigma);
      }
    }
    left = right;
  }
}

}  // namespace

void sweepWithGaussians(std::span<const ImpliedSet> sets, std::span<const Position> corners,
                        GradientSums& sums) noexcept {
  const Position& origin = corners[0];
  std::array<Piece, kMostTerms> pieces;
  // Two pieces cross at most twice.
  std::array<double, kMostTerms*(kMostTerms - 1) + 2> cuts;
  for (std::size_t k = 1; k < corners.size(); ++k) {
    const Position& left = corners[k - 1];
    const Position& right = corners[k];
    const double width = right.minus(left);
    if (!(width > 0)) continue;
    std::size_t count = 0;
    for (std::size_t i = 0; i < sets.size(); ++i) {
      const ImpliedSet& set = sets[i];
      const auto& f = *set.function;
      if (!(set.left <= left && right <= set.right)) continue;
      const bool curved = f.gaussian && (right <= set.top_left || left >= set.top_right);
      const Line line =
          f.gaussian ? Line{i, Part::kTop, set.height, set.height, 0, 1, 1, 0, 0} : Line::of(i, set, left, right);
      pieces[count++] = {curved, line, left.high, (line.y1 - line.y0) / width, f.mean, f.sigma, set.log_ramp};
    }
    if (count == 0) continue;

    const double x0 = left.high;
    const double x1 = right.high;
    double* end = cuts.data();
    *end++ = x0;
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = i + 1; j < count; ++j) end = addCrossings(pieces[i], pieces[j], x0, x1, end);
    }
    *end++ = x1;
    std::sort(cuts.data(), end);
    for (const double* cut = cuts.data() + 1; cut != end; ++cut) {
      const double from = cut[-1];
      const double to = *cut;
      if (from == to && end != cuts.data() + 2) continue;
      const double middle = from + (to - from) / 2;
      const Piece* top = pieces.data();
      for (std::size_t i = 1; i < count; ++i) {
        if (pieces[i].at(middle) > top->at(middle)) top = &pieces[i];
      }
      if (top->curved) {
        addGaussian(*top, from, to, origin.high, sums);
      } else {
        const double t0 = from == x0 ? 0 : (from - x0) / width;
        const double t1 = to == x1 ? 1 : (to - x0) / width;
        sums.addLine(top->line, left.minus(origin), width, t0, t1);
      }
    }
  }
}

}  // namespace tactus::analysis
