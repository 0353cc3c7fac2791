#include "core/fuzzy/centroid.h"

#include <algorithm>
#include <array>
#include <compare>

#include "core/base/check.h"

namespace tactus::fuzzy {
namespace {

/// A position as an unevaluated sum: the corner that clipping cuts into a ramp a few ulps wide lies between two
/// doubles.
struct Position {
  double high;
  double low = 0;  ///< less than half an ulp of `high`

  /// x + offset (Knuth's two-sum).
  static Position beside(double x, double offset) noexcept {
    const double sum = x + offset;
    const double part = sum - x;
    return {sum, (x - (sum - part)) + (offset - part)};
  }
  double minus(const Position& other) const noexcept { return (high - other.high) + (low - other.low); }
  auto operator<=>(const Position&) const = default;
};

/// A trapezoid after implication: zero at `left`, height from `top_left` to `top_right`, zero at `right`.
struct ImpliedSet {
  const MembershipFunction* function;
  double height;       ///< relative to the largest strength
  double ramp_height;  ///< height at which the ramps of the term itself would reach 1
  Position left, top_left, top_right, right;

  /// Height at x in [left, right].
  double at(const Position& x) const noexcept {
    const auto& f = *function;
    double share = 1;
    if (x < top_left) {
      share = x.minus(left) / (f.b - f.a);
    } else if (x > top_right) {
      share = right.minus(x) / (f.d - f.c);
    } else {
      return height;
    }
    return std::min(height, share * ramp_height);
  }
};

ImpliedSet imply(const ActiveTerm& term, Implication implication, double largest) noexcept {
  const auto& f = *term.function;
  const bool scale = implication == Implication::kScale;
  const double s = scale ? 1 : term.strength;
  return {&f,
          term.height,
          scale ? term.height : 1 / largest,
          {f.a},
          std::min(Position::beside(f.a, s * (f.b - f.a)), {f.b}),
          std::max(Position::beside(f.d, -s * (f.d - f.c)), {f.c}),
          {f.d}};
}

/// A line over one interval, by its heights at the two ends.
struct Line {
  double y0, y1;
};

/// Adds the upper envelope of `lines` over an interval of `width` from position x0 on. Walks from crossing to crossing;
/// each step goes to a line that ends higher, so there are at most as many steps as lines, also where several cross in
/// one point. `t` in [0, 1] is the way through the interval.
void addEnvelope(std::span<const Line> lines, double x0, double width, AreaAndMoment& sum) noexcept {
  if (lines.empty()) return;
  const Line* top = lines.data();
  for (const Line& line : lines) {
    if (line.y0 > top->y0 || (line.y0 == top->y0 && line.y1 > top->y1)) top = &line;
  }
  double t = 0;
  double y = top->y0;
  while (true) {
    const Line* next = nullptr;
    double next_t = 1;
    for (const Line& line : lines) {
      if (line.y1 <= top->y1) continue;
      const double below = top->y0 - line.y0;
      const double crossing = std::max(t, below / (below + (line.y1 - top->y1)));
      if (crossing < next_t || (next != nullptr && crossing == next_t && line.y1 > next->y1)) {
        next = &line;
        next_t = crossing;
      }
    }
    if (next == nullptr) break;
    const double next_y = top->y0 + next_t * (top->y1 - top->y0);
    sum.addLinear(x0 + t * width, (next_t - t) * width, y, next_y);
    t = next_t;
    y = next_y;
    top = next;
  }
  sum.addLinear(x0 + t * width, (1 - t) * width, y, top->y1);
}

}  // namespace

double centroidOffset(std::span<const ActiveTerm> terms, Implication implication, double lo, double hi) noexcept {
  TACTUS_CHECK(!terms.empty() && terms.size() <= kMostTerms);
  double largest = 0;
  bool gaussian = false;
  for (const auto& term : terms) {
    largest = std::max(largest, term.strength);
    gaussian = gaussian || term.function->gaussian;
  }
  if (gaussian) return gaussianCentroidOffset(terms, implication, lo, hi);

  std::array<ImpliedSet, kMostTerms> sets;
  std::array<Position, 4 * kMostTerms> corners;
  std::size_t corner_count = 0;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    sets[i] = imply(terms[i], implication, largest);
    for (const Position& x : {sets[i].left, sets[i].top_left, sets[i].top_right, sets[i].right}) {
      corners[corner_count++] = std::clamp(x, {lo}, {hi});
    }
  }
  std::sort(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(corner_count));

  // Positions are measured from the first corner, so a narrow set far from zero keeps its precision.
  const Position origin = corners[0];
  AreaAndMoment sum;
  std::array<Line, kMostTerms> lines;
  for (std::size_t k = 1; k < corner_count; ++k) {
    const Position& x0 = corners[k - 1];
    const Position& x1 = corners[k];
    if (x0 == x1) continue;
    std::size_t line_count = 0;
    for (std::size_t i = 0; i < terms.size(); ++i) {
      if (sets[i].left <= x0 && x1 <= sets[i].right) lines[line_count++] = {sets[i].at(x0), sets[i].at(x1)};
    }
    addEnvelope({lines.data(), line_count}, x0.minus(origin), x1.minus(x0), sum);
  }
  // Sets so narrow that their area underflows lie closer together than any bound can tell.
  return origin.minus({lo}) + (sum.area > 0 ? sum.moment / sum.area : 0);
}

}  // namespace tactus::fuzzy
