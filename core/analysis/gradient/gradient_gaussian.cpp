// The sweep over output sets with Gaussians: crossings by bisection, pieces by quadrature.
#include "core/analysis/gradient/gradient_sets.h"
#include "core/fuzzy/gaussian_pieces.h"

namespace tactus::analysis {
namespace {

/// A piece and the set it belongs to.
struct Piece : fuzzy::CurvePiece {
  Line line;
};

void addGaussian(const Piece& piece, double from, double to, double origin, GradientSums& sums) noexcept {
  fuzzy::visitGaussianMasses(piece, from, to, [&](double x, double mass) {
    sums.addGaussianMass(piece.line.set, x - origin, mass, (x - piece.mean) / piece.sigma);
  });
}

}  // namespace

void sweepWithGaussians(std::span<const ImpliedSet> sets, std::span<const Position> corners,
                        GradientSums& sums) noexcept {
  const Position& origin = corners[0];
  std::array<Piece, fuzzy::kMostTerms> pieces;
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
      const double slope = (line.y1 - line.y0) / width;
      pieces[count++] = {{curved, left.high, line.y0, slope, f.mean, f.sigma, set.log_ramp}, line};
    }
    const double x0 = left.high;
    const double x1 = right.high;
    const std::span<const Piece> found(pieces.data(), count);
    fuzzy::walkHighestPieces(found, x0, x1, 0, [&](const Piece& top, double from, double to) {
      if (top.curved) return addGaussian(top, from, to, origin.high, sums);
      const double t0 = from == x0 ? 0 : (from - x0) / width;
      const double t1 = to == x1 ? 1 : (to - x0) / width;
      sums.addLine(top.line, left.minus(origin), width, t0, t1);
    });
  }
}

}  // namespace tactus::analysis
