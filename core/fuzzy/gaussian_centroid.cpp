// Centroid where Gaussian terms are among the active ones: crossings by bisection, pieces by quadrature.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "core/fuzzy/centroid.h"
#include "core/fuzzy/gaussian_pieces.h"
#include "core/fuzzy/implied_trapezoid.h"

namespace tactus::fuzzy {
namespace {

// Keeps 0 * factor at 0 for strengths below the normal range.
constexpr double kLargestFactor = std::numeric_limits<double>::max();
// Corners per term: a trapezoid has 4, a Gaussian 2 ends, 2 inflections, 2 plateau ends and its mean.
constexpr std::size_t kMostCorners = 7 * kMostTerms + 2;

/// An implied set: height 1 is the largest strength.
struct ImpliedSet {
  const MembershipFunction* function;
  double top;                  ///< height of the plateau
  double factor;               ///< height where the membership would be 1
  ImpliedTrapezoid trapezoid;  ///< where the function is one
};

/// Corners of one implied set, between which it is a line, or a Gaussian without inflection.
std::size_t corners(const ImpliedSet& set, double share, Position* out) noexcept {
  const auto& f = *set.function;
  if (!f.gaussian) {
    const auto& t = set.trapezoid;
    out[0] = t.left, out[1] = t.top_left, out[2] = t.top_right, out[3] = t.right;
    return 4;
  }
  const double plateau = std::sqrt(-2 * std::log(share));
  std::size_t count = 0;
  for (const double u : {-kGaussianReach, -plateau, -1.0, 0.0, 1.0, plateau, kGaussianReach}) {
    out[count++] = Position::beside(f.mean, u * f.sigma);
  }
  return count;
}

/// What `set` is between the neighboring corners `from` and `to`, in positions from `from` on; nothing where it is 0.
std::optional<CurvePiece> pieceOf(const ImpliedSet& set, const Position& from, const Position& to) noexcept {
  const auto& f = *set.function;
  const double length = to.minus(from);
  if (!f.gaussian) {
    if (from < set.trapezoid.left || to > set.trapezoid.right) return std::nullopt;
    const double y0 = set.trapezoid.at(from);
    return CurvePiece{false, 0, y0, (set.trapezoid.at(to) - y0) / length, 0, 1, 0};
  }
  const double mean = Position{f.mean}.minus(from);
  const double u = (length / 2 - mean) / f.sigma;
  if (std::abs(u) > kGaussianReach) return std::nullopt;
  const bool curved = std::exp(-0.5 * u * u) * set.factor < set.top;
  return CurvePiece{curved, 0, set.top, 0, mean, f.sigma, std::log(set.factor)};
}

}  // namespace

double gaussianCentroidOffset(std::span<const ActiveTerm> terms, Implication implication, double lo,
                              double hi) noexcept {
  double largest = 0;
  for (const auto& term : terms) largest = std::max(largest, term.strength);
  const bool clip = implication == Implication::kClip;

  std::array<ImpliedSet, kMostTerms> sets;
  std::array<Position, kMostCorners> corner{};
  std::size_t corner_count = 0;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const auto& term = terms[i];
    const double share = clip ? term.strength : 1;
    const double factor = clip ? std::min(1 / largest, kLargestFactor) : term.height;
    sets[i] = {term.function, term.height, factor, ImpliedTrapezoid::of(*term.function, share, term.height, factor)};
    corner_count += corners(sets[i], share, corner.data() + corner_count);
  }
  for (std::size_t k = 0; k < corner_count; ++k) corner[k] = std::clamp(corner[k], Position{lo}, Position{hi});
  std::sort(corner.begin(), corner.begin() + static_cast<std::ptrdiff_t>(corner_count));

  const Position origin = corner[0];
  AreaAndMoment sum;
  std::array<CurvePiece, kMostTerms> pieces;
  for (std::size_t k = 1; k < corner_count; ++k) {
    const double length = corner[k].minus(corner[k - 1]);
    if (!(1 / length <= std::numeric_limits<double>::max())) continue;  // no length, or one without any area
    std::size_t piece_count = 0;
    for (std::size_t i = 0; i < terms.size(); ++i) {
      if (const auto piece = pieceOf(sets[i], corner[k - 1], corner[k])) pieces[piece_count++] = *piece;
    }
    // Positions count from the corner: a stretch far from 0 and of little strength may be shorter than an ulp of it.
    const double start = corner[k - 1].minus(origin);
    const std::span<const CurvePiece> found(pieces.data(), piece_count);
    walkHighestPieces(found, 0, length, [&](const CurvePiece& top, double from, double to) {
      if (!top.curved) return sum.addLinear(start + from, to - from, top.at(from), top.at(to));
      visitGaussianMasses(top, from, to, [&](double x, double mass) {
        sum.area += mass;
        sum.moment += mass * (start + x);
      });
    });
  }
  return origin.minus({lo}) + sum.moment / sum.area;
}

}  // namespace tactus::fuzzy
