// Fuzzy sets as polylines, for drawing and for their centroid.
#pragma once

#include <span>
#include <vector>

#include "core/fuzzy/force_model.h"
#include "core/fuzzy/membership.h"

namespace tactus::analysis {

struct Vertex {
  double x = 0;
  double height = 0;

  bool operator==(const Vertex&) const = default;
};

/// Vertices with ascending x. Two with the same x form a vertical edge. The set is 0 outside.
using Polyline = std::vector<Vertex>;

/// An output term after implication at a strength in (0, 1], cut to [lo, hi]. Trapezoids: the exact vertices.
/// Gaussians: a vertex every sigma/20, which deviates from the curve by at most 1/3200 of the strength.
Polyline impliedSet(const fuzzy::MembershipFunction& term, double strength, fuzzy::Implication implication, double lo,
                    double hi);

/// The pointwise maximum of sets, with a vertex at each crossing.
Polyline upperEnvelope(std::span<const Polyline> sets);

/// Centroid of a set with an area > 0.
double centroid(const Polyline& set);

}  // namespace tactus::analysis
