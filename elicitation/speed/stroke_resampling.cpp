#include "elicitation/speed/stroke_resampling.h"

#include <algorithm>
#include <map>

#include "core/base/check.h"

namespace tactus::elicitation {
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

}  // namespace tactus::elicitation
