#include "core/analysis/pull/force_search.h"

#include <algorithm>
#include <cmath>

namespace tactus::analysis {
namespace {

constexpr double kSameForce = 1e-13;  // relative to the size of the force and 1 N: rounding of a centroid
constexpr double kNoJump = 1e-9;      // between two neighboring numbers, where the force is steep but continuous
constexpr int kMostHalvings = 200;

bool isSame(double force_n, double target_n) {
  return std::abs(force_n - target_n) <= kSameForce * std::max(1.0, std::abs(target_n));
}

/// The root between two points on different sides of the target: false position with halved weights (Illinois; Dowell
/// and Jarratt 1971), with a halving in between. Nothing if the bracket closes on a jump or a hole.
std::optional<double> rootBetween(ForcePoint low, ForcePoint high, const ForceAt& force, double target_n) {
  double low_weight = 1;
  double high_weight = 1;
  for (int i = 0; i < kMostHalvings; ++i) {
    const double low_gap = (low.force_n - target_n) * low_weight;
    const double high_gap = (high.force_n - target_n) * high_weight;
    double x = (low.at * high_gap - high.at * low_gap) / (high_gap - low_gap);
    if (i % 4 == 3 || !(x > low.at && x < high.at)) x = low.at + (high.at - low.at) / 2;
    if (x <= low.at || x >= high.at) break;
    const auto there = force(x);
    if (!there) return std::nullopt;
    if (isSame(*there, target_n)) return x;
    if ((*there < target_n) == (low.force_n < target_n)) {
      low = {x, *there};
      low_weight = 1;
      high_weight /= 2;
    } else {
      high = {x, *there};
      high_weight = 1;
      low_weight /= 2;
    }
  }
  const ForcePoint& closer = std::abs(low.force_n - target_n) < std::abs(high.force_n - target_n) ? low : high;
  const bool meets = std::abs(closer.force_n - target_n) <= kNoJump * std::max(1.0, std::abs(target_n));
  return meets ? std::optional(closer.at) : std::nullopt;
}

}  // namespace

void Reach::look(double delta, double force_n, double target_n) {
  if (!nearest) min_n = max_n = force_n;
  min_n = std::min(min_n, force_n);
  max_n = std::max(max_n, force_n);
  const double off = std::abs(force_n - target_n);
  const double best = nearest ? std::abs(nearest->force_n - target_n) : off;
  if (!nearest || off < best || (off == best && std::abs(delta) < std::abs(nearest->at))) nearest = {delta, force_n};
  if (isSame(force_n, target_n)) meets(delta, target_n);
}

void Reach::meets(double delta, double target_n) {
  if (!nearest) min_n = max_n = target_n;
  min_n = std::min(min_n, target_n);
  max_n = std::max(max_n, target_n);
  if (exact && std::abs(*exact) <= std::abs(delta)) return;
  exact = delta;
  nearest = {delta, target_n};
}

std::vector<double> crossings(std::span<const ForcePoint> points, const ForceAt& force, double target_n) {
  std::vector<double> out;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (isSame(points[k].force_n, target_n)) {
      out.push_back(points[k].at);
    } else if (k > 0 && !isSame(points[k - 1].force_n, target_n) &&
               (points[k - 1].force_n < target_n) != (points[k].force_n < target_n)) {
      if (const auto root = rootBetween(points[k - 1], points[k], force, target_n)) out.push_back(*root);
    }
  }
  return out;
}

Reach searchDeltas(const DeltaRange& range, const ForceAt& force, double target_n, std::span<const double> bends) {
  std::vector<double> places = {0};
  for (const double end : {range.low, range.high}) {
    for (int i = 1; i <= kSteps && end != 0; ++i) places.push_back(i == kSteps ? end : end * i / kSteps);
  }
  for (const double bend : bends) {
    if (range.holds(bend)) places.push_back(bend);
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());

  Reach reach;
  std::vector<ForcePoint> stretch;  // without a hole
  const auto finish = [&] {
    for (const double root : crossings(stretch, force, target_n)) reach.meets(root, target_n);
    stretch.clear();
  };
  for (const double place : places) {
    if (const auto there = force(place)) {
      reach.look(place, *there, target_n);
      stretch.push_back({place, *there});
    } else {
      finish();
    }
  }
  finish();
  return reach;
}

}  // namespace tactus::analysis
