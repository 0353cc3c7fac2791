#include "core/analysis/polyline.h"

#include <algorithm>
#include <cmath>

#include "core/fuzzy/centroid.h"
#include "core/fuzzy/upper_envelope.h"

namespace tactus::analysis {
namespace {

// Beyond this many sigmas a Gaussian is below 1e-15.
constexpr double kReach = 8.5;
constexpr int kStepsPerSigma = 20;

/// Adds the part of the line from `from` to `to` that lies in [lo, hi].
void addLine(const Vertex& from, const Vertex& to, double lo, double hi, Polyline& out) {
  if (to.x <= from.x || to.x <= lo || from.x >= hi) return;
  const auto at = [&](double x) -> Vertex {
    if (x <= from.x) return from;
    if (x >= to.x) return to;
    return {x, from.height + (to.height - from.height) * ((x - from.x) / (to.x - from.x))};
  };
  for (const Vertex& vertex : {at(lo), at(hi)}) {
    if (out.empty() || !(out.back() == vertex)) out.push_back(vertex);
  }
}

/// A set during a walk from left to right.
struct Walker {
  const Polyline* set;
  std::size_t segment = 0;  ///< from vertex `segment` to the next one

  bool covers(double x0, double x1) {
    while (segment + 2 < set->size() && (*set)[segment + 1].x <= x0) ++segment;
    return set->size() > 1 && (*set)[segment].x <= x0 && (*set)[segment + 1].x >= x1;
  }
  double at(double x) const {
    const Vertex& p = (*set)[segment];
    const Vertex& q = (*set)[segment + 1];
    if (x == q.x) return q.height;
    return p.height + (q.height - p.height) * ((x - p.x) / (q.x - p.x));
  }
};

void addVertex(double x, double height, Polyline& out) {
  if (out.empty() || out.back().x != x || out.back().height != height) out.push_back({x, height});
}

/// Adds the maximum of lines over [x0, x1].
void addMaximum(std::span<const fuzzy::EndHeights> lines, double x0, double x1, Polyline& out) {
  const auto position = [&](double t) { return t <= 0 ? x0 : t >= 1 ? x1 : x0 + t * (x1 - x0); };
  fuzzy::walkUpperEnvelope(lines, [&](const auto&, const fuzzy::EnvelopePoint& from, const fuzzy::EnvelopePoint& to) {
    addVertex(position(from.t), from.height, out);
    addVertex(position(to.t), to.height, out);
  });
}

}  // namespace

Polyline impliedSet(const fuzzy::MembershipFunction& term, double strength, fuzzy::Implication implication, double lo,
                    double hi) {
  const bool clip = implication == fuzzy::Implication::kClip;
  Polyline corners;
  if (term.gaussian) {
    // With one more vertex at each end of the plateau, which lies between two of the regular ones.
    std::vector<double> offsets;
    const int steps = static_cast<int>(kReach * kStepsPerSigma);
    for (int i = -steps; i <= steps; ++i) offsets.push_back(static_cast<double>(i) / kStepsPerSigma);
    const double plateau = clip ? std::sqrt(-2 * std::log(strength)) : 0;
    offsets.insert(offsets.end(), {-plateau, plateau});
    std::sort(offsets.begin(), offsets.end());
    for (const double u : offsets) {
      const double membership = std::exp(-0.5 * u * u);
      corners.push_back({term.mean + u * term.sigma, clip ? std::min(strength, membership) : strength * membership});
    }
  } else {
    const double share = clip ? strength : 1;
    const double left = std::min(term.b, term.a + share * (term.b - term.a));
    const double right = std::max(term.c, term.d - share * (term.d - term.c));
    corners = {{term.a, 0}, {left, strength}, {right, strength}, {term.d, 0}};
  }
  Polyline out;
  for (std::size_t k = 1; k < corners.size(); ++k) addLine(corners[k - 1], corners[k], lo, hi, out);
  return out;
}

Polyline upperEnvelope(std::span<const Polyline> sets) {
  std::vector<double> xs;
  std::vector<Walker> walkers;
  for (const auto& set : sets) {
    walkers.push_back({&set});
    for (const auto& vertex : set) xs.push_back(vertex.x);
  }
  std::sort(xs.begin(), xs.end());
  xs.erase(std::unique(xs.begin(), xs.end()), xs.end());
  Polyline out;
  std::vector<fuzzy::EndHeights> lines;
  for (std::size_t k = 1; k < xs.size(); ++k) {
    lines.clear();
    for (auto& walker : walkers) {
      if (walker.covers(xs[k - 1], xs[k])) lines.push_back({walker.at(xs[k - 1]), walker.at(xs[k])});
    }
    if (lines.empty()) lines.push_back({0, 0});
    addMaximum(lines, xs[k - 1], xs[k], out);
  }
  return out;
}

double centroid(const Polyline& set) {
  const double origin = set.front().x;
  double highest = 0;
  for (const auto& vertex : set) highest = std::max(highest, vertex.height);
  fuzzy::AreaAndMoment sum;
  for (std::size_t k = 1; k < set.size(); ++k) {
    const Vertex& from = set[k - 1];
    const Vertex& to = set[k];
    sum.addLinear(from.x - origin, to.x - from.x, from.height / highest, to.height / highest);
  }
  return origin + sum.moment / sum.area;
}

}  // namespace tactus::analysis
