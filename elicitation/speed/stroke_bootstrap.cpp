#include "elicitation/speed/stroke_bootstrap.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "core/base/check.h"
#include "core/base/statistics.h"
#include "elicitation/clustering/fcm_data.h"
#include "elicitation/clustering/fcm_descent.h"

namespace tactus::elicitation {
namespace {

constexpr double kTolerance = 1e-4;  // of the gaps between centers; far below what the bins of the strokes cost
constexpr int kMostDraws = 100;      // before a replicate takes the centers of all strokes

bool ascending(const std::vector<double>& centres) {
  return std::adjacent_find(centres.begin(), centres.end(), std::not_fn(std::less<>())) == centres.end();
}

}  // namespace

base::Result<StrokeBootstrap> StrokeBootstrap::of(std::span<const study::SpeedSample> samples,
                                                  std::span<const std::string> levels, std::span<const double> centres,
                                                  const SpeedTermSettings& settings, std::uint64_t seed) {
  TACTUS_CHECK(!samples.empty());
  StrokeResampler strokes(samples, levels);
  if (const auto found = strokes.levelWithoutChoice()) {
    return base::fail(base::ErrorCode::kData,
                      "speeds of participant " + samples.front().participant + ", level " + levels[found->first],
                      std::to_string(found->second) + (found->second == 1 ? " stroke" : " strokes"),
                      "at least 2 strokes of each level for an interval");
  }
  return StrokeBootstrap(std::move(strokes), {centres.begin(), centres.end()}, settings, seed);
}

StrokeBootstrap::StrokeBootstrap(StrokeResampler strokes, std::vector<double> centres,
                                 const SpeedTermSettings& settings, std::uint64_t seed)
    : strokes_(std::move(strokes)),
      own_mm_s_(std::move(centres)),
      start_(own_mm_s_),
      settings_(settings),
      random_(seed) {
  for (double& centre : start_) centre = strokes_.toScaled(centre);
  settings_.fcm.tolerance = kTolerance;
  if (settings_.centres == SpeedCentres::kClusters) sums_ = StrokeSums(strokes_, start_, settings_.fcm.m);
  setSpreads();
}

std::vector<double> StrokeBootstrap::drawnCentres() {
  strokes_.draw(random_);
  return centresNow();
}

std::vector<double> StrokeBootstrap::centresNow() {
  std::vector<double> centres;
  if (settings_.centres == SpeedCentres::kLevelMeans) {
    centres = strokes_.levelMeans();
    std::sort(centres.begin(), centres.end());
    return centres;
  }
  if (strokes_.values().size() < start_.size()) return {};
  const FcmData data = scaledFcmData(strokes_.values(), strokes_.weights());
  centres = descend(data, sums_.firstStep(strokes_.times()), FcmBeginning::kNearMinimum, settings_.fcm, {}).centres;
  for (double& centre : centres) centre = strokes_.toOriginal(centre);
  return centres;
}

std::vector<double> StrokeBootstrap::valuesOf(const std::vector<double>& centres) const {
  std::vector<double> values = centres;
  const auto ramps = alphaCutRamps(centres, settings_.fcm.m, settings_.alpha);
  TACTUS_CHECK(ramps.has_value());
  for (const Ramp& ramp : *ramps) values.insert(values.end(), {ramp.p, ramp.q});
  return values;
}

/// With as many strokes in each level the level does not matter. Otherwise leaving out one stroke after another tells
/// how much of the variance of each value comes from which level (jackknife, Tukey 1958).
void StrokeBootstrap::setSpreads() {
  const auto counts = strokes_.strokeCounts();
  std::vector<DrawSpread> levels;
  for (const std::size_t count : counts) levels.push_back(spreadOf(count));
  const std::size_t values = valuesOf(own_mm_s_).size();
  std::vector<std::vector<double>> variances(values, std::vector<double>(counts.size()));
  const bool equal = std::adjacent_find(counts.begin(), counts.end(), std::not_equal_to<>()) == counts.end();
  for (std::size_t level = 0; level < counts.size() && !equal; ++level) {
    std::vector<std::vector<double>> without(values);
    for (std::size_t stroke = 0; stroke < counts[level]; ++stroke) {
      strokes_.leaveOut(level, stroke);
      const auto centres = centresNow();
      if (centres.empty() || !ascending(centres)) continue;
      const auto found = valuesOf(centres);
      for (std::size_t k = 0; k < values; ++k) without[k].push_back(found[k]);
    }
    for (std::size_t k = 0; k < values; ++k) {
      const double sd = base::standardDeviation(without[k]);
      const auto n = static_cast<double>(counts[level]);
      variances[k][level] = sd * sd * std::pow(n - 1, 3) / (n * n);  // (n - 1) / n of the jackknife's, as draws have
    }
  }
  std::vector<DrawSpread> spreads;
  for (const auto& one : variances) spreads.push_back(equal ? levels.front() : mixedSpread(one, levels));
  const std::size_t centres = own_mm_s_.size();
  centre_spreads_.assign(spreads.begin(), spreads.begin() + static_cast<std::ptrdiff_t>(centres));
  for (std::size_t k = 0; k + 1 < centres; ++k) {
    ramp_spreads_.push_back({spreads[centres + 2 * k], spreads[centres + 2 * k + 1]});
  }
}

void StrokeBootstrap::add(std::size_t replicates) {
  for (std::size_t i = 0; i < replicates; ++i) {
    std::vector<double> centres = drawnCentres();
    for (int draws = 1; draws < kMostDraws && (centres.empty() || !ascending(centres)); ++draws) {
      centres = drawnCentres();
    }
    if (centres.empty() || !ascending(centres)) centres = own_mm_s_;
    auto ramps = alphaCutRamps(centres, settings_.fcm.m, settings_.alpha);
    TACTUS_CHECK(ramps.has_value());
    centres_.push_back(std::move(centres));
    ramps_.push_back(std::move(*ramps));
  }
}

SpeedIntervals StrokeBootstrap::intervals(double coverage) const {
  SpeedIntervals out;
  out.replicates = replicates();
  if (out.replicates == 0) return out;
  std::vector<double> draws(out.replicates);
  const auto interval = [&](const auto& list, double own, const DrawSpread& spread, auto value) {
    std::transform(list.begin(), list.end(), draws.begin(), value);
    return drawInterval(own, draws, spread, lowest(), coverage);
  };
  const auto own = valuesOf(own_mm_s_);
  const std::size_t centres = own_mm_s_.size();
  for (std::size_t k = 0; k < centres; ++k) {
    out.centres.push_back(
        interval(centres_, own[k], centre_spreads_[k], [k](const std::vector<double>& one) { return one[k]; }));
  }
  for (std::size_t k = 0; k + 1 < centres; ++k) {
    const double* const ramp = &own[centres + 2 * k];
    out.ramps.push_back(
        {interval(ramps_, ramp[0], ramp_spreads_[k].p, [k](const std::vector<Ramp>& one) { return one[k].p; }),
         interval(ramps_, ramp[1], ramp_spreads_[k].q, [k](const std::vector<Ramp>& one) { return one[k].q; })});
  }
  return out;
}

}  // namespace tactus::elicitation
