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
    own.bins.push_back({binOf(scaled), 1, scaled});
  }
  for (std::size_t level = 0; level < levels_.size(); ++level) {
    times_[level].resize(levels_[level].size());
    for (StrokeBins& stroke : levels_[level]) {
      auto& bins = stroke.bins;
      std::stable_sort(bins.begin(), bins.end(), [](const Bin& a, const Bin& b) { return a.place < b.place; });
      std::vector<Bin> joined;
      for (const Bin& bin : bins) {
        if (joined.empty() || joined.back().place != bin.place) joined.push_back({bin.place, 0, 0});
        joined.back().count += 1;
        joined.back().sum += bin.sum;
      }
      bins = std::move(joined);
    }
  }
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
      for (const Bin& bin : levels_[level][stroke].bins) {
        bin_count_[bin.place] += times * bin.count;
        bin_sum_[bin.place] += times * bin.sum;
      }
    }
  }
  values_.clear();
  weights_.clear();
  for (std::size_t place = 0; place < kBins; ++place) {
    if (bin_count_[place] == 0) continue;
    values_.push_back(bin_sum_[place] / bin_count_[place]);
    weights_.push_back(bin_count_[place]);
  }
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
