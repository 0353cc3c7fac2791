#include "app/editing/edit_impact.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>

#include "core/analysis/sample_points.h"
#include "core/base/check.h"
#include "core/fuzzy/batch.h"
#include "elicitation/force/noticeable_force.h"

namespace tactus::editing {
namespace {

using analysis::SamplePoints;
using fuzzy::CompiledModel;
using fuzzy::Evaluation;
using fuzzy::ForceModel;

// 4,096 points: about 2 ms for one expert. The allowance counts rules looked at and bounds the time of many experts.
constexpr std::size_t kMostPoints = 4096;
constexpr std::size_t kFewestPoints = 64;
constexpr std::size_t kAllowance = 100'000'000;
// Fuzzification and centroid of one expert, in rules.
constexpr std::size_t kFixedCost = 32;

std::size_t costOf(const ForceModel& model) {
  std::size_t cost = 1;
  for (const auto& expert : model.experts) cost += expert.rules.size() + kFixedCost;
  return cost;
}

/// Vertices of both models in the changed region, and the middles between them.
std::vector<std::vector<double>> valuesInside(const ForceModel& before, const ForceModel& after,
                                              const std::vector<analysis::InputRange>& region) {
  auto vertices = analysis::sortedVertices(before);
  const auto further = analysis::sortedVertices(after);
  std::vector<std::vector<double>> values;
  for (std::size_t i = 0; i < region.size(); ++i) {
    auto& all = vertices[i];
    all.insert(all.end(), further[i].begin(), further[i].end());
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    values.push_back(analysis::valuesWorthALook(all, region[i].low, region[i].high));
  }
  return values;
}

/// Forces at many points at once: lanes of the fast form, where the model has one.
struct Forces {
  std::vector<double> force_n;
  std::vector<std::uint8_t> fired;

  Forces(const CompiledModel& model, const std::vector<std::vector<double>>& columns)
      : force_n(columns.front().size()), fired(columns.front().size()) {
    std::vector<std::span<const double>> inputs(columns.begin(), columns.end());
    fuzzy::evaluateBatch(model, inputs, {force_n, fired});
  }
};

class Comparison {
 public:
  /// Counts a point; returns the difference there.
  std::optional<double> add(const std::vector<double>& point, const Evaluation& before, const Evaluation& after) {
    ++out_.points;
    if (before.fired && !after.fired) ++out_.opened;
    if (after.fired && !before.fired) ++out_.closed;
    if (!before.fired || !after.fired) return std::nullopt;
    const double newtons = std::abs(after.force_n - before.force_n);
    out_.noticeable =
        std::max(out_.noticeable, newtons / elicitation::justNoticeableDifference(std::abs(before.force_n)));
    if (newtons > out_.largest_n) {
      out_.largest_n = newtons;
      out_.at = point;
      out_.before_n = before.force_n;
      out_.after_n = after.force_n;
    }
    return newtons;
  }

  EditImpact result() const { return out_; }

 private:
  EditImpact out_;
};

}  // namespace

EditImpact editImpact(const ForceModel& before, const CompiledModel& compiled_before, const ForceModel& after,
                      const CompiledModel& compiled_after) {
  TACTUS_CHECK(before.inputs.size() == after.inputs.size());
  const auto region = changedRegion(before, after);
  if (region.empty()) return {};
  const std::size_t most = std::clamp(kAllowance / (costOf(before) + costOf(after)), kFewestPoints, kMostPoints);
  const SamplePoints points(valuesInside(before, after, region), most);

  std::vector<std::vector<double>> columns(region.size());
  for (std::size_t p = 0; p < points.size(); ++p) {
    const auto point = points[p];
    for (std::size_t i = 0; i < point.size(); ++i) columns[i].push_back(point[i]);
  }
  const Forces first(compiled_before, columns);
  const Forces second(compiled_after, columns);

  Comparison comparison;
  std::optional<double> worst;
  std::size_t worst_point = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const auto difference =
        comparison.add(points[p], {first.force_n[p], first.fired[p] != 0}, {second.force_n[p], second.fired[p] != 0});
    if (!difference || (worst && *difference <= *worst)) continue;
    worst = difference;
    worst_point = p;
  }
  if (worst && *worst > 0) {
    points.climb(points.choice(worst_point), *worst, [&](const SamplePoints::Choice& choice) {
      const auto point = points.at(choice);
      return comparison.add(point, compiled_before.evaluate(point), compiled_after.evaluate(point));
    });
  }
  return comparison.result();
}

}  // namespace tactus::editing
