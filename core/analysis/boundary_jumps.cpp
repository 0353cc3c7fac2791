#include "core/analysis/boundary_jumps.h"

#include <cmath>
#include <functional>

#include "core/analysis/sample_points.h"

namespace tactus::analysis {
namespace {

/// One face of a hole: the last value of `input` inside and the first one outside.
struct Face {
  std::size_t input;
  double inside, outside;
};

/// First double that belongs to the range from below, and from above.
double lowest(const InputRange& range) { return range.low_included ? range.low : std::nextafter(range.low, HUGE_VAL); }
double highest(const InputRange& range) {
  return range.high_included ? range.high : std::nextafter(range.high, -HUGE_VAL);
}

std::vector<Face> facesOf(const fuzzy::ForceModel& model, const Hole& hole) {
  std::vector<Face> faces;
  for (std::size_t i = 0; i < hole.ranges.size(); ++i) {
    const double low = lowest(hole.ranges[i]);
    const double high = highest(hole.ranges[i]);
    if (low > model.inputs[i].min) faces.push_back({i, low, std::nextafter(low, -HUGE_VAL)});
    if (high < model.inputs[i].max) faces.push_back({i, high, std::nextafter(high, HUGE_VAL)});
  }
  return faces;
}

/// Jump in newtons between a point inside and one outside, or nothing where there is none to speak of.
using Jump =
    std::function<std::optional<double>(const std::vector<double>& inside, const std::vector<double>& outside)>;

std::optional<BoundaryJump> largestJump(const ForceProbe& probe, const Hole& hole, std::size_t samples,
                                        const Jump& jump) {
  std::optional<BoundaryJump> largest;
  for (const Face& face : facesOf(probe.model(), hole)) {
    if (!probe.affords()) break;
    std::vector<std::vector<double>> values;
    for (std::size_t i = 0; i < hole.ranges.size(); ++i) {
      values.push_back(i == face.input ? std::vector<double>{face.inside}
                                       : probe.values(i, lowest(hole.ranges[i]), highest(hole.ranges[i])));
    }
    const SamplePoints points(std::move(values), samples);
    const auto look = [&](const SamplePoints::Choice& choice) -> std::optional<double> {
      if (!probe.affords()) return std::nullopt;
      const auto inside = points.at(choice);
      auto outside = inside;
      outside[face.input] = face.outside;
      const auto newtons = jump(inside, outside);
      if (newtons && (!largest || *newtons > largest->newtons)) largest = BoundaryJump{*newtons, outside, inside};
      return newtons;
    };
    std::optional<double> best;
    SamplePoints::Choice where;
    for (std::size_t p = 0; p < points.size(); ++p) {
      const auto choice = points.choice(p);
      const auto newtons = look(choice);
      if (newtons && (!best || *newtons > *best)) best = newtons, where = choice;
    }
    if (best) points.climb(where, *best, look);
  }
  return largest;
}

}  // namespace

std::optional<BoundaryJump> jumpToDefault(ForceProbe& probe, const Hole& hole, std::optional<std::size_t> expert,
                                          std::size_t samples) {
  return largestJump(probe, hole, samples, [&](const auto& /*inside*/, const auto& outside) -> std::optional<double> {
    const auto beside = expert ? probe.expert(*expert, outside) : probe.mean(outside);
    if (!beside.fired) return std::nullopt;
    return std::abs(beside.force_n - probe.model().default_force_n);
  });
}

std::optional<BoundaryJump> jumpOfMean(ForceProbe& probe, const Hole& hole, std::size_t expert, std::size_t samples) {
  return largestJump(probe, hole, samples, [&](const auto& inside, const auto& outside) -> std::optional<double> {
    if (!probe.expert(expert, outside).fired) return std::nullopt;
    const auto without = probe.mean(inside);
    if (!without.fired) return std::nullopt;
    return std::abs(probe.mean(outside).force_n - without.force_n);
  });
}

}  // namespace tactus::analysis
