#include "core/analysis/gradient_centroid.h"

#include <algorithm>

#include "core/analysis/gradient_sets.h"
#include "core/base/check.h"

namespace tactus::analysis {
namespace {

using fuzzy::kMostTerms;

// A trapezoid has 4 corners, a Gaussian 2 ends, 2 plateau ends, 2 inflections and its mean; then lo and hi.
constexpr std::size_t kMostCorners = 7 * kMostTerms;

/// Adds the upper envelope of `lines` over an interval of `width` from x0 on. Walks from crossing to crossing; each
/// step goes to a line that ends higher, so there are at most as many steps as lines. Of coinciding lines the first
/// counts.
void addEnvelope(std::span<const Line> lines, double x0, double width, GradientSums& sums) noexcept {
  if (lines.empty()) return;
  const Line* top = lines.data();
  for (const Line& line : lines) {
    if (line.y0 > top->y0 || (line.y0 == top->y0 && line.y1 > top->y1)) top = &line;
  }
  double t = 0;
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
    sums.addLine(*top, x0, width, t, next_t);
    t = next_t;
    top = next;
  }
  sums.addLine(*top, x0, width, t, 1);
}

void sweep(std::span<const ImpliedSet> sets, std::span<const Position> corners, GradientSums& sums) noexcept {
  std::array<Line, kMostTerms> lines;
  for (std::size_t k = 1; k < corners.size(); ++k) {
    const Position& x0 = corners[k - 1];
    const Position& x1 = corners[k];
    if (x0 == x1) continue;
    std::size_t count = 0;
    for (std::size_t i = 0; i < sets.size(); ++i) {
      if (sets[i].left <= x0 && x1 <= sets[i].right) lines[count++] = Line::of(i, sets[i], x0, x1);
    }
    addEnvelope({lines.data(), count}, x0.minus(corners[0]), x1.minus(x0), sums);
  }
}

}  // namespace

double centroidGradient(std::span<const FiringTerm> terms, fuzzy::Implication implication, double lo, double hi,
                        std::span<SetGradient> out) noexcept {
  TACTUS_CHECK(!terms.empty() && terms.size() <= kMostTerms && out.size() >= terms.size());
  double largest = 0;
  for (const auto& term : terms) largest = std::max(largest, term.strength);

  std::array<ImpliedSet, kMostTerms> implied;
  std::array<Position, kMostCorners> corners;
  std::size_t corner_count = 0;
  bool gaussian = false;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const ImpliedSet& set = implied[i] = ImpliedSet::of(terms[i], implication, largest);
    for (const Position& x : {set.left, set.top_left, set.top_right, set.right}) corners[corner_count++] = x;
    const auto& f = *set.function;
    if (!f.gaussian) continue;
    gaussian = true;
    for (const double x : {f.mean - f.sigma, f.mean, f.mean + f.sigma}) corners[corner_count++] = {x};
  }
  for (std::size_t k = 0; k < corner_count; ++k) corners[k] = std::clamp(corners[k], {lo}, {hi});
  std::sort(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(corner_count));

  // Positions are measured from the first corner, so a narrow set far from zero keeps its precision.
  const std::span<const ImpliedSet> sets(implied.data(), terms.size());
  const std::span<const Position> sorted(corners.data(), corner_count);
  GradientSums sums(sets, implication);
  gaussian ? sweepWithGaussians(sets, sorted, sums) : sweep(sets, sorted, sums);
  sums.addVerticalEdges(lo, hi, sorted[0]);
  return sorted[0].minus({lo}) + sums.finish(out);
}

}  // namespace tactus::analysis
