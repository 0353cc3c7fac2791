#include "elicitation/speed/stroke_bootstrap.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <utility>

#include "core/base/check.h"
#include "core/base/statistics.h"
#include "elicitation/clustering/fcm_data.h"
#include "elicitation/clustering/fcm_pass.h"
#include "elicitation/clustering/fcm_starts.h"
#include "elicitation/clustering/positive_solve.h"

namespace tactus::elicitation {
namespace {

constexpr int kMostHalvings = 200;

/// Probability above t >= 0.
double upperTail(double t, double degrees) {
  const double all = degrees + t * t;
  return base::incompleteBeta(degrees / 2, 0.5, degrees / all, t * t / all) / 2;
}

}  // namespace

double studentQuantile(double share, double degrees) {
  TACTUS_CHECK(share >= 0 && share <= 1 && degrees > 0);
  if (share < 0.5) return -studentQuantile(1 - share, degrees);
  if (share == 0.5) return 0;
  if (share == 1) return std::numeric_limits<double>::infinity();
  const double tail = 1 - share;
  double low = 0;
  double high = 1;
  while (upperTail(high, degrees) > tail && high < 1e150) {
    low = high;
    high *= 2;
  }
  for (int i = 0; i < kMostHalvings && low < high; ++i) {
    const double middle = low + (high - low) / 2;
    if (middle == low || middle == high) break;
    (upperTail(middle, degrees) > tail ? low : high) = middle;
  }
  return high;
}

namespace {

/// Widened variances of all parts, their sum, and the fewest degrees of freedom.
struct Widened {
  std::vector<double> variances;
  double draws = 0;
  double sum = 0;
  double fewest_degrees = 0;
};

Widened widened(std::span<const double> variances, std::span<const DrawSpread> parts) {
  TACTUS_CHECK(!parts.empty() && variances.size() == parts.size());
  Widened out;
  out.fewest_degrees = parts.front().degrees;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    out.variances.push_back(variances[i] * parts[i].widening);
    out.draws += variances[i];
    out.sum += out.variances.back();
    out.fewest_degrees = std::min(out.fewest_degrees, parts[i].degrees);
  }
  return out;
}

}  // namespace

DrawSpread spreadOf(std::size_t strokes) {
  TACTUS_CHECK(strokes >= 2);
  const auto n = static_cast<double>(strokes);
  return {n / (n - 1), n - 1};
}

DrawSpread mixedSpread(std::span<const double> variances, std::span<const DrawSpread> parts) {
  const Widened all = widened(variances, parts);
  if (!(all.sum > 0)) return {1, all.fewest_degrees};
  double inverse = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) inverse += all.variances[i] / all.sum / parts[i].degrees;
  return {all.sum / all.draws, 1 / inverse};
}

DrawSpread pooledSpread(std::span<const double> variances, std::span<const DrawSpread> persons) {
  const Widened all = widened(variances, persons);
  if (!(all.sum > 0)) return {1, all.fewest_degrees};
  double inverse = 0;
  for (std::size_t i = 0; i < persons.size(); ++i) {
    const double share = all.variances[i] / all.sum;
    inverse += share * share / persons[i].degrees;
  }
  return {all.sum / all.draws, 1 / inverse};
}

Interval drawInterval(double value, const std::vector<double>& draws, const DrawSpread& spread, double lowest,
                      double coverage) {
  const double sd = base::standardDeviation(draws);
  if (!(sd > 0)) return {value, value};
  const double half = studentQuantile((1 + coverage) / 2, spread.degrees) * std::sqrt(spread.widening) * sd;
  return {std::max(value - half, std::min(lowest, value)), value + half};
}

namespace {

std::size_t binOf(double scaled) {
  const double place = (scaled + 1) / 2 * static_cast<double>(StrokeResampler::kBins);
  return std::min(static_cast<std::size_t>(std::max(place, 0.0)), StrokeResampler::kBins - 1);
}

void addTimes(double times, const std::vector<double>& from, std::span<double> to) {
  const double* const source = from.data();
  double* const target = to.data();
  for (std::size_t i = 0; i < from.size(); ++i) target[i] += times * source[i];
}

}  // namespace

StrokeResampler::StrokeResampler(std::span<const study::SpeedSample> samples, std::span<const std::string> levels)
    : levels_(levels.size()), times_(levels.size()), bin_count_(kBins), bin_sum_(kBins) {
  TACTUS_CHECK(!samples.empty());
  const auto [low, high] = std::minmax_element(
      samples.begin(), samples.end(), [](const auto& a, const auto& b) { return a.speed_mm_s < b.speed_mm_s; });
  half_range_mm_s_ = high->speed_mm_s / 2 - low->speed_mm_s / 2;
  middle_mm_s_ = low->speed_mm_s + half_range_mm_s_;
  TACTUS_CHECK(half_range_mm_s_ > 0);

  std::vector<std::map<int, std::size_t>> places(levels.size());
  for (const auto& sample : samples) {
    const auto level = static_cast<std::size_t>(std::find(levels.begin(), levels.end(), sample.level) - levels.begin());
    TACTUS_CHECK(level < levels.size());
    auto& strokes = levels_[level];
    const std::size_t stroke = places[level].try_emplace(sample.stroke, strokes.size()).first->second;
    if (stroke == strokes.size()) strokes.emplace_back();
    const double scaled = toScaled(sample.speed_mm_s);
    StrokeBins& own = strokes[stroke];
    own.count += 1;
    own.sum += scaled;
    const std::size_t bin = binOf(scaled);
    if (own.counts.empty()) own.first = bin;
    if (bin < own.first) {
      own.counts.insert(own.counts.begin(), own.first - bin, 0.0);
      own.sums.insert(own.sums.begin(), own.first - bin, 0.0);
      own.first = bin;
    }
    if (bin - own.first >= own.counts.size()) {
      own.counts.resize(bin - own.first + 1);
      own.sums.resize(bin - own.first + 1);
    }
    own.counts[bin - own.first] += 1;
    own.sums[bin - own.first] += scaled;
  }
  for (std::size_t level = 0; level < levels_.size(); ++level) times_[level].resize(levels_[level].size());
  takeAll();
}

std::optional<std::pair<std::size_t, std::size_t>> StrokeResampler::levelWithoutChoice() const {
  for (std::size_t level = 0; level < levels_.size(); ++level) {
    if (levels_[level].size() < 2) return std::pair{level, levels_[level].size()};
  }
  return std::nullopt;
}

void StrokeResampler::draw(base::Random& random) {
  for (auto& times : times_) {
    std::fill(times.begin(), times.end(), 0.0);
    for (std::size_t i = 0; i < times.size(); ++i) {
      times[static_cast<std::size_t>(random.below(static_cast<int>(times.size())))] += 1;
    }
  }
  collect();
}

void StrokeResampler::takeAll() {
  for (auto& times : times_) std::fill(times.begin(), times.end(), 1.0);
  collect();
}

void StrokeResampler::takeOnly(std::size_t level, std::size_t stroke) {
  for (auto& times : times_) std::fill(times.begin(), times.end(), 0.0);
  times_[level][stroke] = 1;
  collect();
}

void StrokeResampler::leaveOut(std::size_t level, std::size_t stroke) {
  for (auto& times : times_) std::fill(times.begin(), times.end(), 1.0);
  times_[level][stroke] = 0;
  collect();
}

std::vector<std::size_t> StrokeResampler::strokeCounts() const {
  std::vector<std::size_t> counts;
  for (const auto& level : levels_) counts.push_back(level.size());
  return counts;
}

void StrokeResampler::collect() {
  std::fill(bin_count_.begin(), bin_count_.end(), 0.0);
  std::fill(bin_sum_.begin(), bin_sum_.end(), 0.0);
  for (std::size_t level = 0; level < levels_.size(); ++level) {
    for (std::size_t stroke = 0; stroke < levels_[level].size(); ++stroke) {
      const double times = times_[level][stroke];
      if (times == 0) continue;
      const StrokeBins& own = levels_[level][stroke];
      addTimes(times, own.counts, std::span(bin_count_).subspan(own.first));
      addTimes(times, own.sums, std::span(bin_sum_).subspan(own.first));
    }
  }
  values_.resize(kBins);
  weights_.resize(kBins);
  std::size_t filled = 0;
  for (std::size_t place = 0; place < kBins; ++place) {
    const double count = bin_count_[place];
    values_[filled] = bin_sum_[place] / (count > 0 ? count : 1);
    weights_[filled] = count;
    filled += count > 0 ? 1 : 0;  // an empty bin is written over
  }
  values_.resize(filled);
  weights_.resize(filled);
}

std::vector<double> StrokeResampler::levelMeans() const {
  std::vector<double> means;
  for (std::size_t level = 0; level < levels_.size(); ++level) {
    double count = 0;
    double sum = 0;
    for (std::size_t stroke = 0; stroke < levels_[level].size(); ++stroke) {
      count += times_[level][stroke] * levels_[level][stroke].count;
      sum += times_[level][stroke] * levels_[level][stroke].sum;
    }
    TACTUS_CHECK(count > 0);
    means.push_back(toOriginal(sum / count));
  }
  return means;
}

namespace {

constexpr double kLongestStep = 0.25;  // of the smallest gap between centers; what is longer may leave the valley of J

}  // namespace

StrokeSums::StrokeSums(StrokeResampler& strokes, std::span<const double> centres, double m)
    : centres_(centres.begin(), centres.end()), longest_(2 * kLongestStep) {
  for (std::size_t k = 1; k < centres_.size(); ++k) {
    longest_ = std::min(longest_, kLongestStep * (centres_[k] - centres_[k - 1]));
  }
  FcmPass pass(centres_.size(), m);
  FcmSums sums;
  const auto counts = strokes.strokeCounts();
  for (std::size_t level = 0; level < counts.size(); ++level) {
    sums_.emplace_back();
    for (std::size_t stroke = 0; stroke < counts[level]; ++stroke) {
      strokes.takeOnly(level, stroke);
      pass.run(scaledFcmData(strokes.values(), strokes.weights()), centres_, sums);
      std::vector<double>& own = sums_[level].emplace_back(sums.pull);
      own.insert(own.end(), sums.curvature.begin(), sums.curvature.end());
    }
  }
  strokes.takeAll();
}

std::vector<double> StrokeSums::firstStep(std::span<const std::vector<double>> times) {
  const std::size_t c = centres_.size();
  step_.assign(c, 0.0);
  matrix_.assign(c * c, 0.0);
  for (std::size_t level = 0; level < sums_.size(); ++level) {
    for (std::size_t stroke = 0; stroke < sums_[level].size(); ++stroke) {
      const double factor = times[level][stroke];
      if (factor == 0) continue;
      const std::vector<double>& own = sums_[level][stroke];
      for (std::size_t k = 0; k < c; ++k) step_[k] += factor * own[k];
      for (std::size_t k = 0; k < c * c; ++k) matrix_[k] += factor * own[c + k];
    }
  }
  if (!solvePositive(matrix_, step_)) return centres_;
  std::vector<double> out = centres_;
  for (std::size_t k = 0; k < c; ++k) {
    if (!(std::abs(step_[k]) <= longest_)) return centres_;
    out[k] += step_[k];
  }
  if (out.front() < -1 || out.back() > 1) return centres_;
  return out;
}

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
