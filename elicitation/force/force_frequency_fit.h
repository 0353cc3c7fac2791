// Least squares of ordered ramps: the terms that sum to one and lie closest to shares of answers.
#pragma once

#include <span>
#include <vector>

namespace tactus::elicitation {

/// The shares of the terms (lowest first, together 1) among the answers at one force.
struct FrequencyPoint {
  double force_n = 0;
  double weight = 1;  ///< > 0, the number of answers
  std::vector<double> shares;
};

/// Where one term hands over to the next: the lower has membership 1 up to `begin_n`, the higher from `end_n` on, and
/// between them they sum to 1.
struct TermRamp {
  double begin_n = 0;
  double end_n = 0;
};

/// The ramps between neighbouring terms, begin <= end <= next begin, inside [min_n, max_n] with min_n < max_n, for
/// which the weighted sum of squares of membership - share over points and terms is least. `points` in strictly
/// ascending force inside the universe, at least one, all with the same number of terms (at least one); one ramp fewer
/// than terms comes back. Where points leave a ramp open it is as wide as it may be, and ramps that share a gap are
/// equally wide. Answers cannot tell ramps that are steeper than their own spacing: a ramp that holds a point is at
/// least as wide as the smallest distance between two points, one between two points half as wide over the number of
/// ramps, so that all of them fit into one gap. Only outside the points may a ramp vanish.
///
/// Deterministic: dynamic programming over a grid of places for the ends finds the valley (the whole grid, so no start
/// values), the same over ever finer places around the ends finds its bottom, to a micronewton.
std::vector<TermRamp> fitRamps(std::span<const FrequencyPoint> points, double min_n, double max_n);

}  // namespace tactus::elicitation
