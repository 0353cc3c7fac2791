#include "core/fuzzy/centroid.h"

#include <algorithm>
#include <array>

#include "core/base/check.h"
#include "core/fuzzy/implied_trapezoid.h"
#include "core/fuzzy/upper_envelope.h"

namespace tactus::fuzzy {
namespace {

ImpliedTrapezoid imply(const ActiveTerm& term, Implication implication, double largest) noexcept {
  const bool scale = implication == Implication::kScale;
  return ImpliedTrapezoid::of(*term.function, scale ? 1 : term.strength, term.height,
                              scale ? term.height : 1 / largest);
}

/// Adds the maximum of `lines` over an interval of `width` from position x0 on.
void addEnvelope(std::span<const EndHeights> lines, double x0, double width, AreaAndMoment& sum) noexcept {
  walkUpperEnvelope(lines, [&](const EndHeights&, const EnvelopePoint& from, const EnvelopePoint& to) {
    sum.addLinear(x0 + from.t * width, (to.t - from.t) * width, from.height, to.height);
  });
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

  std::array<ImpliedTrapezoid, kMostTerms> sets;
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
  std::array<EndHeights, kMostTerms> lines;
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
