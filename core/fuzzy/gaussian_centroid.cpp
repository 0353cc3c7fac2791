// The pieces of the aggregated set where Gaussian terms may be among the active ones: crossings by bisection, pieces by
// quadrature.
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

/// A piece and the term whose set it is of.
struct TermPiece : CurvePiece {
  std::size_t term;
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

/// Adds the piece of the highest term over [from, to], in positions from `start` on.
void add(const CurvePiece& piece, double start, double from, double to, AreaAndMoment& sum) noexcept {
  if (!piece.curved) return sum.addLinear(start + from, to - from, piece.at(from), piece.at(to));
  visitGaussianMasses(piece, from, to, [&](double x, double mass) {
    sum.area += mass;
    sum.moment += mass * (start + x);
  });
}

/// Calls `visit(piece, start, from, to)` for each piece of the maximum of `terms` in turn: from start + from to
/// start + to, in positions from the returned one on. `same`: as for walkHighestPieces.
template <class Visit>
Position walkGaussianMaximum(std::span<const ActiveTerm> terms, Implication implication, double lo, double hi,
                             double same, const Visit& visit) noexcept {
  double largest = 0;
  for (const auto& term : terms) largest = std::max(largest, term.strength);
  const bool clip = implication == Implication::kClip;

  std::array<ImpliedSet, kMostTerms> sets;
  std::array<Position, kMostCorners> corner;
  std::size_t corner_count = 0;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const auto& term = terms[i];
    const double share = clip ? term.strength : 1;
    const double factor = clip ? std::min(1 / largest, kLargestFactor) : term.height;
    sets[i] = {term.function, term.height, factor, ImpliedTrapezoid::of(*term.function, share, term.height, factor)};
    corner_count += corners(sets[i], share, corner.data() + corner_count);
  }
  for (std::size_t k = 0; k < corner_count; ++k) corner[k] = std::clamp(corner[k], Position{lo}, Position{hi});
  std::sort(corner.data(), corner.data() + corner_count);

  const Position origin = corner[0];
  std::array<TermPiece, kMostTerms> pieces;
  std::array<double, kMostTerms> highest;
  for (std::size_t k = 1; k < corner_count; ++k) {
    const double length = corner[k].minus(corner[k - 1]);
    if (!(1 / length <= std::numeric_limits<double>::max())) continue;  // no length, or one without any area
    std::size_t piece_count = 0;
    double floor = 0;  // below the maximum everywhere
    for (std::size_t i = 0; i < terms.size(); ++i) {
      const auto piece = pieceOf(sets[i], corner[k - 1], corner[k]);
      if (!piece) continue;
      const double left = piece->at(0);
      const double right = piece->at(length);
      highest[piece_count] = std::max(left, right);  // as the mean is a corner
      floor = std::max(floor, std::min(left, right));
      pieces[piece_count++] = {*piece, i};
    }
    // Most crossings lie below the maximum, and each costs a search.
    std::size_t kept = 0;
    for (std::size_t p = 0; p < piece_count; ++p) {
      if (highest[p] >= floor) pieces[kept++] = pieces[p];
    }
    // Positions count from the corner: a stretch far from 0 and of little strength may be shorter than an ulp of it.
    const double start = corner[k - 1].minus(origin);
    const std::span<const TermPiece> found(pieces.data(), kept);
    walkHighestPieces(found, 0, length, same,
                      [&](const TermPiece& top, double from, double to) { visit(top, start, from, to); });
  }
  return origin;
}

}  // namespace

double gaussianCentroidOffset(std::span<const ActiveTerm> terms, Implication implication, double lo,
                              double hi) noexcept {
  AreaAndMoment sum;
  const Position origin = walkGaussianMaximum(
      terms, implication, lo, hi, 0,
      [&](const TermPiece& piece, double start, double from, double to) { add(piece, start, from, to, sum); });
  return origin.minus({lo}) + sum.moment / sum.area;
}

void gaussianSliceMoments(std::span<const ActiveTerm> terms, Implication implication, double lo, double hi,
                          std::span<AreaAndMoment> slices) noexcept {
  constexpr double kSame = 1e-12;
  const Position origin = walkGaussianMaximum(terms, implication, lo, hi, kSame,
                                              [&](const TermPiece& piece, double start, double from, double to) {
                                                add(piece, start, from, to, slices[piece.term]);
                                              });
  for (AreaAndMoment& slice : slices) slice.moment += origin.minus({lo}) * slice.area;
}

}  // namespace tactus::fuzzy
