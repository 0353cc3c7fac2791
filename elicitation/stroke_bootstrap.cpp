#include "elicitation/stroke_bootstrap.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "core/base/check.h"
#include "core/base/statistics.h"
#include "elicitation/fcm_data.h"
#include "elicitation/fcm_descent.h"

namespace tactus::elicitation {
namespace {

constexpr double kTolerance = 1e-9;  // of the gaps between centres; far below any interval
constexpr int kMostDraws = 100;      // before a replicate takes the centres of all strokes

bool ascending(const std::vector<double>& centres) {
  return std::adjacent_find(centres.begin(), centres.end(), std::not_fn(std::less<>())) == centres.end();
}

}  // namespace

Interval percentileInterval(const std::vector<double>& values, double coverage) {
  return {base::quantile(values, (1 - coverage) / 2), base::quantile(values, (1 + coverage) / 2)};
}

base::Result<StrokeBootstrap> StrokeBootstrap::of(std::span<const study::SpeedSample> samples,
                                                  std::span<const std::string> levels, std::span<const double> centres,
                                                  const SpeedSettings& settings, std::uint64_t seed) {
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

StrokeBootstrap::StrokeBootstrap(StrokeResampler strokes, std::vector<double> centres, const SpeedSettings& settings,
                                 std::uint64_t seed)
    : strokes_(std::move(strokes)),
      own_mm_s_(std::move(centres)),
      start_(own_mm_s_),
      settings_(settings),
      random_(seed) {
  for (double& centre : start_) centre = strokes_.toScaled(centre);
  settings_.fcm.tolerance = kTolerance;
}

std::vector<double> StrokeBootstrap::drawnCentres() {
  strokes_.draw(random_);
  std::vector<double> centres;
  if (settings_.centres == SpeedCentres::kLevelMeans) {
    centres = strokes_.levelMeans();
    std::sort(centres.begin(), centres.end());
    return centres;
  }
  if (strokes_.values().size() < start_.size()) return {};
  const FcmData data = scaledFcmData(strokes_.values(), strokes_.weights());
  centres = descend(data, start_, FcmBeginning::kNearMinimum, settings_.fcm, {}).centres;
  for (double& centre : centres) centre = strokes_.toOriginal(centre);
  return centres;
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
  std::vector<double> values(out.replicates);
  const auto interval = [&](const auto& list, auto value) {
    std::transform(list.begin(), list.end(), values.begin(), value);
    return percentileInterval(values, coverage);
  };
  for (std::size_t k = 0; k < start_.size(); ++k) {
    out.centres.push_back(interval(centres_, [k](const std::vector<double>& one) { return one[k]; }));
  }
  for (std::size_t k = 0; k + 1 < start_.size(); ++k) {
    out.ramps.push_back({interval(ramps_, [k](const std::vector<Ramp>& one) { return one[k].p; }),
                         interval(ramps_, [k](const std::vector<Ramp>& one) { return one[k].q; })});
  }
  return out;
}

}  // namespace tactus::elicitation
