#include "core/analysis/expert_spread.h"

#include <cmath>
#include <tuple>
#include <utility>

#include "core/analysis/term_conversion.h"

namespace tactus::analysis {
namespace {

/// The spread at a point; nothing where fewer than two experts that count fire.
std::optional<ExpertSpread> spreadAt(ForceProbe& probe, std::vector<double> point,
                                     const NoticeableDifference& noticeable) {
  std::vector<std::pair<std::size_t, double>> forces;
  for (std::size_t e = 0; e < probe.model().experts.size(); ++e) {
    if (probe.compiled().weight(e) == 0) continue;
    const auto force = probe.expert(e, point);
    if (force.fired) forces.emplace_back(e, force.force_n);
  }
  if (forces.size() < 2) return std::nullopt;
  ExpertSpread out;
  out.mean_n = probe.mean(point).force_n;
  out.low = out.high = out.nearest = forces.front().first;
  out.low_n = out.high_n = out.nearest_n = forces.front().second;
  for (const auto& [expert, force_n] : forces) {
    if (force_n < out.low_n) std::tie(out.low, out.low_n) = std::pair{expert, force_n};
    if (force_n > out.high_n) std::tie(out.high, out.high_n) = std::pair{expert, force_n};
    if (std::abs(force_n - out.mean_n) < std::abs(out.nearest_n - out.mean_n)) {
      std::tie(out.nearest, out.nearest_n) = std::pair{expert, force_n};
    }
  }
  out.mean_far_from_all = std::abs(out.nearest_n - out.mean_n) > noticeable(std::abs(out.mean_n));
  out.point = std::move(point);
  return out;
}

}  // namespace

std::vector<ExpertSpread> expertsApart(ForceProbe& probe, std::optional<std::size_t> region_input,
                                       const NoticeableDifference& noticeable, double times, std::size_t samples) {
  const auto& model = probe.model();
  const SamplePoints points = kinkPoints(model, samples);

  const std::size_t regions = region_input ? model.inputs[*region_input].terms.size() : 1;
  std::vector<std::optional<ExpertSpread>> largest(regions);
  for (std::size_t p = 0; p < points.size() && probe.affords(); ++p) {
    auto point = points[p];
    const auto region =
        region_input ? strongestTerm(model.inputs[*region_input], point[*region_input]) : std::optional{std::size_t{0}};
    if (!region) continue;
    auto spread = spreadAt(probe, std::move(point), noticeable);
    if (!spread || spread->high_n - spread->low_n <= times * noticeable(std::abs(spread->mean_n))) continue;
    const auto rank = [](const ExpertSpread& s) { return std::pair{s.mean_far_from_all, s.high_n - s.low_n}; };
    auto& best = largest[*region];
    if (best && rank(*spread) <= rank(*best)) continue;
    if (region_input) spread->region = model.inputs[*region_input].terms[*region].id;
    best = std::move(*spread);
  }
  std::vector<ExpertSpread> out;
  for (auto& one : largest) {
    if (one) out.push_back(std::move(*one));
  }
  return out;
}

}  // namespace tactus::analysis
