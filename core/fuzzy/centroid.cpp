#include "core/fuzzy/centroid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

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

/// A line over an interval, and the term whose set it is of.
struct TermLine : EndHeights {
  std::size_t term;
};

/// Whether two lines are one flank, rounded twice.
bool coincide(const EndHeights& p, const EndHeights& q) noexcept {
  constexpr double kSame = 1e-12;
  const double most = kSame * std::max(p.y0, p.y1);
  return std::abs(p.y0 - q.y0) <= most && std::abs(p.y1 - q.y1) <= most;
}

/// Calls `visit(line, x0, width, y0, y1)` for each piece of the maximum of the terms, all trapezoids, in turn;
/// positions are measured from the returned one on. `Line`: EndHeights or TermLine; lines of the latter that coincide
/// are one, the first.
template <class Line, class Visit>
[[gnu::always_inline]] inline Position walkMaximum(std::span<const ActiveTerm> terms, Implication implication,
                                                   double lo, double hi, double largest, const Visit& visit) noexcept {
  constexpr bool kOfTerms = std::is_same_v<Line, TermLine>;
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
  std::array<Line, kMostTerms> lines;
  for (std::size_t k = 1; k < corner_count; ++k) {
    const Position& x0 = corners[k - 1];
    const Position& x1 = corners[k];
    if (x0 == x1) continue;
    std::size_t line_count = 0;
    for (std::size_t i = 0; i < terms.size(); ++i) {
      if (!(sets[i].left <= x0 && x1 <= sets[i].right)) continue;
      if constexpr (kOfTerms) {
        const TermLine line{{sets[i].at(x0), sets[i].at(x1)}, i};
        const auto is_same = [&](const TermLine& other) { return coincide(line, other); };
        if (std::none_of(lines.data(), lines.data() + line_count, is_same)) lines[line_count++] = line;
      } else {
        lines[line_count++] = {sets[i].at(x0), sets[i].at(x1)};
      }
    }
    const double start = x0.minus(origin);
    const double width = x1.minus(x0);
    walkUpperEnvelope(std::span<const Line>(lines.data(), line_count),
                      [&](const Line& line, const EnvelopePoint& from, const EnvelopePoint& to) {
                        visit(line, start + from.t * width, (to.t - from.t) * width, from.height, to.height);
                      });
  }
  return origin;
}

struct Largest {
  double strength = 0;
  bool gaussian = false;  ///< one of the terms is
};

Largest largestOf(std::span<const ActiveTerm> terms) noexcept {
  TACTUS_CHECK(!terms.empty() && terms.size() <= kMostTerms);
  Largest out;
  for (const auto& term : terms) {
    out.strength = std::max(out.strength, term.strength);
    out.gaussian = out.gaussian || term.function->gaussian;
  }
  return out;
}

}  // namespace

double centroidOffset(std::span<const ActiveTerm> terms, Implication implication, double lo, double hi) noexcept {
  const auto [largest, gaussian] = largestOf(terms);
  if (gaussian) return gaussianCentroidOffset(terms, implication, lo, hi);
  AreaAndMoment sum;
  const Position origin = walkMaximum<EndHeights>(
      terms, implication, lo, hi, largest,
      [&](const EndHeights&, double x0, double width, double y0, double y1) { sum.addLinear(x0, width, y0, y1); });
  // Sets so narrow that their area underflows lie closer together than any bound can tell.
  return origin.minus({lo}) + (sum.area > 0 ? sum.moment / sum.area : 0);
}

void sliceMoments(std::span<const ActiveTerm> terms, Implication implication, double lo, double hi,
                  std::span<AreaAndMoment> slices) noexcept {
  const auto [largest, gaussian] = largestOf(terms);
  std::fill(slices.begin(), slices.end(), AreaAndMoment{});
  if (gaussian) return gaussianSliceMoments(terms, implication, lo, hi, slices);
  const Position origin = walkMaximum<TermLine>(
      terms, implication, lo, hi, largest, [&](const TermLine& line, double x0, double width, double y0, double y1) {
        slices[line.term].addLinear(x0, width, y0, y1);
      });
  for (AreaAndMoment& slice : slices) slice.moment += origin.minus({lo}) * slice.area;
}

}  // namespace tactus::fuzzy
