#include "app/editing/edit_impact.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>

#include "core/analysis/sample_points.h"
#include "core/base/check.h"
#include "core/base/error.h"
#include "core/fuzzy/batch.h"
#include "core/fuzzy/scene.h"
#include "elicitation/force/noticeable_force.h"

namespace tactus::editing {
namespace {

constexpr double kRounding = 1e-12;  // share of a force; less is no difference of the models

struct GhostForces {
  std::vector<double> force_n;
  std::vector<std::uint8_t> fired;
};

base::Result<GhostForces> along(const fuzzy::CompiledModel& model, const std::vector<std::optional<double>>& fixed,
                                std::span<const double> places) {
  TACTUS_TRY(const auto scene, fuzzy::Scene::specialize(model, fixed));
  GhostForces out{std::vector<double>(places.size()), std::vector<std::uint8_t>(places.size())};
  scene.evaluateBatch(std::span(&places, 1), {out.force_n, out.fired});
  return out;
}

}  // namespace

base::Result<GhostCurve> ghostCurve(const fuzzy::CompiledModel& compiled_before,
                                    const fuzzy::CompiledModel& compiled_after, std::size_t input,
                                    std::span<const double> point, std::span<const double> places) {
  TACTUS_CHECK(compiled_before.inputCount() == compiled_after.inputCount());
  if (input >= point.size() || point.size() != compiled_after.inputCount() || places.empty()) {
    return base::fail(base::ErrorCode::kValue, "curve",
                      "input " + std::to_string(input) + ", " + std::to_string(point.size()) + " values, " +
                          std::to_string(places.size()) + " places",
                      "an input of the model, a value for each, a place or more");
  }
  std::vector<std::optional<double>> fixed(point.begin(), point.end());
  fixed[input].reset();
  TACTUS_TRY(const auto before, along(compiled_before, fixed, places));
  TACTUS_TRY(const auto after, along(compiled_after, fixed, places));

  GhostCurve out;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const GhostCurve::Point here{places[k], before.force_n[k], after.force_n[k], before.fired[k] != 0,
                                 after.fired[k] != 0};
    out.points.push_back(here);
    if (here.before_fired && !here.after_fired) ++out.opened;
    if (!here.before_fired && here.after_fired) ++out.closed;
    if (!here.before_fired || !here.after_fired) continue;
    const double newtons = std::abs(here.after_n - here.before_n);
    if (newtons <= kRounding * std::abs(here.before_n)) continue;
    const double noticeable = newtons / elicitation::justNoticeableDifference(std::abs(here.before_n));
    if (noticeable > out.noticeable) {
      out.noticeable = noticeable;
      out.noticeable_at = here.at;
    }
    if (newtons <= out.largest_n) continue;
    out.largest_n = newtons;
    out.largest_at = here.at;
    out.before_n = here.before_n;
    out.after_n = here.after_n;
  }
  return out;
}

bool include(EditImpact& impact, const GhostCurve& curve, std::size_t input, std::span<const double> point) {
  bool grew = false;
  if (curve.largest_at && curve.largest_n > impact.largest_n) {
    impact.largest_n = curve.largest_n;
    impact.at.assign(point.begin(), point.end());
    impact.at[input] = *curve.largest_at;
    impact.before_n = curve.before_n;
    impact.after_n = curve.after_n;
    grew = true;
  }
  grew = grew || curve.noticeable > impact.noticeable || curve.opened > impact.opened || curve.closed > impact.closed;
  impact.noticeable = std::max(impact.noticeable, curve.noticeable);
  impact.opened = std::max(impact.opened, curve.opened);
  impact.closed = std::max(impact.closed, curve.closed);
  return grew;
}

ModelGhost::ModelGhost(const fuzzy::ForceModel& before, const fuzzy::CompiledModel& compiled_before,
                       const fuzzy::ForceModel& after, const fuzzy::CompiledModel& compiled_after)
    : model_before_(before),
      model_after_(after),
      compiled_before_(compiled_before),
      compiled_after_(compiled_after),
      region_(changedRegion(before, after)) {
  TACTUS_CHECK(before.inputs.size() == after.inputs.size());
}

base::Result<GhostCurve> ModelGhost::curve(std::size_t input, std::span<const double> point, std::size_t count) const {
  const auto& inputs = model_after_.inputs;
  if (input >= inputs.size() || point.size() != inputs.size() || count < 2) {
    return base::fail(base::ErrorCode::kValue, "curve",
                      "input " + std::to_string(input) + ", " + std::to_string(point.size()) + " values, " +
                          std::to_string(count) + " points",
                      "an input of the model, a value for each, two points or more");
  }
  std::vector<double> places;
  for (std::size_t k = 0; k < count; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(count - 1);
    places.push_back(inputs[input].min * (1 - share) + inputs[input].max * share);
  }
  return ghostCurve(compiled_before_, compiled_after_, input, point, places);
}

analysis::ForceDifference ModelGhost::difference() const {
  return analysis::forceDifference(model_before_, compiled_before_, model_after_, compiled_after_);
}

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
