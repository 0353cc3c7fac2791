// A list of terms that sums to one, as its ramps (pull_edit.h), and how far each gesture can go before the order of the
// vertices breaks.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/analysis/partition.h"
#include "core/analysis/pull/pull_edit.h"

namespace tactus::analysis {

struct Ramps {
  TermOrder order;           ///< of the terms, as indices in the list
  std::vector<double> p;     ///< ramp r between the terms order[r] and order[r + 1] begins here
  std::vector<double> q;     ///< and ends here
  double low = 0, high = 1;  ///< the universe
  double narrowest = 0;      ///< ramp
};

/// Nothing for a list that does not sum to one.
std::optional<Ramps> rampsOf(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms);

/// Writes the vertices that differ between `before` and `after`; the others keep their bits. A triangle that loses its
/// peak becomes a trapezoid.
void writeRamps(const Ramps& before, const Ramps& after, std::vector<fuzzy::Term>& terms);

/// A place of a gesture in a list: see PullEdit::place.
struct GesturePlace {
  Gesture gesture;
  std::size_t place;
};

/// All gestures of a list: four for each ramp, two for each inner term.
std::vector<GesturePlace> gesturesOf(const Ramps& ramps);

/// Values of a gesture's delta, 0 among them.
struct DeltaRange {
  double low = 0;
  double high = 0;

  bool holds(double delta) const noexcept { return delta >= low && delta <= high; }
};

/// How far the gesture can go: low <= p < q <= p of the next ramp <= high, each ramp at least `narrowest` wide.
DeltaRange allowedDeltas(const Ramps& ramps, Gesture gesture, std::size_t place);

Ramps moved(Ramps ramps, Gesture gesture, std::size_t place, double delta);

/// Membership of the left term of ramp `ramp` at x as far as this ramp decides it: 1 up to p, 0 from q on.
double shareBelow(const Ramps& ramps, std::size_t ramp, double x);

/// The memberships of all terms at x, by index in the list.
std::vector<double> membershipsAt(const Ramps& ramps, double x);

/// The delta with which `gesture` brings ramp `ramp` to the place where the left term has the membership `share` at x;
/// nothing if it does not move this ramp, or no delta does it. The caller compares with `allowedDeltas`.
std::optional<double> deltaFor(const Ramps& ramps, const GesturePlace& gesture, std::size_t ramp, double share,
                               double x);

}  // namespace tactus::analysis
