#include "core/analysis/gradient/gradient_centroid.h"

#include <algorithm>

#include "core/analysis/gradient/gradient_sets.h"
#include "core/base/check.h"
#include "core/fuzzy/upper_envelope.h"

namespace tactus::analysis {
namespace {

using fuzzy::kMostTerms;

// A trapezoid has 4 corners, a Gaussian 2 ends, 2 plateau ends, 2 inflections and its mean; then lo and hi.
constexpr std::size_t kMostCorners = 7 * kMostTerms;

/// Adds the maximum of `lines` over an interval of `width` from x0 on.
void addEnvelope(std::span<const Line> lines, double x0, double width, GradientSums& sums) noexcept {
  fuzzy::walkUpperEnvelope(lines, [&](const Line& top, const fuzzy::EnvelopePoint& from,
                                      const fuzzy::EnvelopePoint& to) { sums.addLine(top, x0, width, from.t, to.t); });
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

double centroidGradient(std::span<const fuzzy::ActiveTerm> terms, fuzzy::Implication implication, double lo, double hi,
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
