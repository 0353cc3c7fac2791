#include "core/analysis/term_moments.h"

#include <algorithm>

#include "core/fuzzy/gaussian_pieces.h"

namespace tactus::analysis {
namespace {

// Moments below this lose digits.
constexpr double kTiny = 1e-280;

/// Adds the moment of a line from height y0 at x0 to y1 at x1; the piece lies on one side of `about`.
void addPiece(double x0, double x1, double y0, double y1, double about, Moments& out) {
  if (x1 <= x0) return;
  const double moment = (x1 - x0) * ((x0 - about) * (2 * y0 + y1) + (x1 - about) * (y0 + 2 * y1)) / 6;
  (moment < 0 ? out.left : out.right) += std::abs(moment);
}

/// Adds a line from height y0 at x0 to y1 at x1, cut to [0, width] and at `about`.
void addLine(double x0, double x1, double y0, double y1, double about, double width, Moments& out) {
  if (x1 <= x0) return;
  const auto at = [&](double x) { return y0 + (y1 - y0) * ((x - x0) / (x1 - x0)); };
  const double from = std::clamp(x0, 0.0, width);
  const double to = std::clamp(x1, 0.0, width);
  const double middle = std::clamp(about, from, to);
  addPiece(from, middle, at(from), at(middle), about, out);
  addPiece(middle, to, at(middle), at(to), about, out);
}

/// Adds the part of a Gaussian, relative to `strength`, between x0 and x1, cut to [0, width] and at `about`. Sums of
/// positive masses, exact to rounding (gaussian_pieces.h).
void addTail(const BoundedTerm& term, double strength, double x0, double x1, double about, double width, Moments& out) {
  const fuzzy::CurvePiece curve{true, 0, 0, 0, term.b, term.sigma, -std::log(strength)};
  const double from = std::clamp(x0, 0.0, width);
  const double to = std::clamp(x1, 0.0, width);
  const double middle = std::clamp(about, from, to);
  const auto add = [&](double x, double mass) { (x < about ? out.left : out.right) += mass * std::abs(x - about); };
  fuzzy::visitGaussianMasses(curve, from, middle, add);
  fuzzy::visitGaussianMasses(curve, middle, to, add);
}

}  // namespace

Moments momentsOf(const BoundedTerm& term, double strength, double about, double width) {
  Moments out;
  if (term.gaussian()) {
    const double plateau = term.reachAt(strength);
    // Beyond this the tail is e^-60 of the highest point in the universe, far below rounding.
    const double nearest = std::max({plateau, -term.b, term.b - width});
    const double end = std::sqrt(nearest * nearest + 120 * term.sigma * term.sigma);
    addTail(term, strength, term.b - end, term.b - plateau, about, width, out);
    addLine(term.b - plateau, term.b + plateau, 1, 1, about, width, out);
    addTail(term, strength, term.b + plateau, term.b + end, about, width, out);
    if (out.left + out.right < kTiny)
      out.left = std::numeric_limits<double>::infinity();  // too far away to be computed: nothing is proved
    return out;
  }
  const double left = std::min(term.b, term.a + strength * (term.b - term.a));
  const double right = std::max(term.c, term.d - strength * (term.d - term.c));
  addLine(term.a, left, 0, 1, about, width, out);
  addLine(left, right, 1, 1, about, width, out);
  addLine(right, term.d, 1, 0, about, width, out);
  return out;
}

}  // namespace tactus::analysis
