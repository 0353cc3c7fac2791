#include "experiments/speed_from_positions.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/check.h"
#include "core/base/text.h"

namespace tactus::experiments {

void EvenPositions::add(const PositionSample& sample) {
  TACTUS_CHECK(sample.time_s > last_.time_s);
  const double slope = (sample.position_mm - last_.position_mm) / (sample.time_s - last_.time_s);
  for (;; ++fine_count_) {
    const double time_s = start_s_ + static_cast<double>(fine_count_) * kFineS;
    if (time_s > sample.time_s) break;
    block_sum_mm_ += last_.position_mm + slope * (time_s - last_.time_s);
    if (++block_size_ == kBlock) {
      positions_mm_.push_back(block_sum_mm_ / kBlock);
      block_sum_mm_ = 0;
      block_size_ = 0;
    }
  }
  last_ = sample;
}

void EvenPositions::forgetBefore(std::size_t step) {
  while (first_ < step && !positions_mm_.empty()) {
    positions_mm_.pop_front();
    ++first_;
  }
}

namespace {

using base::ErrorCode;
using base::fail;
using base::Result;

constexpr double kTimeRoundingS = 1e-9;       // decimal time stamps; a step of just ten ticks is no gap
constexpr double kLongestRecordingS = 36000;  // longer ones are a slip in the unit of time

Result<void> checkPositions(std::span<const double> time_s, std::span<const double> depth_mm) {
  if (time_s.size() != depth_mm.size()) {
    return fail(ErrorCode::kData, "positions", std::to_string(depth_mm.size()) + " depths",
                std::to_string(time_s.size()) + ", one for each time stamp");
  }
  for (std::size_t i = 0; i < time_s.size(); ++i) {
    const std::string place = "position " + std::to_string(i + 1);
    for (const double value : {time_s[i], depth_mm[i]}) {
      if (std::isfinite(value)) continue;
      return fail(ErrorCode::kValue, place + (std::isfinite(time_s[i]) ? ", depth_mm" : ", time_s"),
                  base::formatNumber(value), "a finite number");
    }
    if (i > 0 && !(time_s[i] > time_s[i - 1])) {
      return fail(ErrorCode::kValue, place + ", time_s",
                  base::formatNumber(time_s[i]) + " s after " + base::formatNumber(time_s[i - 1]) + " s",
                  "times that rise");
    }
  }
  if (time_s.empty()) return fail(ErrorCode::kData, "positions", "none", "positions of a motion");
  if (time_s.back() - time_s.front() > kLongestRecordingS) {
    return fail(ErrorCode::kLimit, "positions", base::formatNumber(time_s.back() - time_s.front()) + " s",
                "at most " + base::formatNumber(kLongestRecordingS) + " s");
  }
  return {};
}

std::vector<MotionSample> resampled(std::span<const double> time_s, std::span<const double> depth_mm) {
  // A last time stamp that misses the raster by rounding alone still counts.
  const double steps = (time_s.back() - time_s.front()) * kSpeedRateHz;
  const auto count = static_cast<std::size_t>(std::floor(steps + kTimeRoundingS * kSpeedRateHz)) + 1;
  std::vector<MotionSample> samples(count);
  std::size_t next = 1;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = std::min(time_s.front() + static_cast<double>(i) / kSpeedRateHz, time_s.back());
    while (next + 1 < time_s.size() && time_s[next] < t) ++next;
    if (time_s.size() == 1) {
      samples[i] = {t, depth_mm[0], 0};
      continue;
    }
    const double share = (t - time_s[next - 1]) / (time_s[next] - time_s[next - 1]);
    samples[i] = {t, depth_mm[next - 1] + share * (depth_mm[next] - depth_mm[next - 1]), 0};
  }
  return samples;
}

/// The parabola a + b j + c j^2 of least squares through `count` samples from `first` on, j counted from the window's
/// middle in steps of the raster (half steps where the count is even); its slope b + 2 c j.
struct Parabola {
  double middle = 0;
  double linear = 0;
  double square = 0;

  Parabola(std::span<const MotionSample> samples, std::size_t first, std::size_t count)
      : middle(static_cast<double>(first) + (static_cast<double>(count) - 1) / 2) {
    // The middle's depth is taken off first, so that a large depth costs no digits.
    const double base_mm = samples[first + count / 2].depth_mm;
    double s0 = 0, s2 = 0, s4 = 0, y0 = 0, y1 = 0, y2 = 0;
    for (std::size_t i = first; i < first + count; ++i) {
      const double j = static_cast<double>(i) - middle;
      const double y = samples[i].depth_mm - base_mm;
      s0 += 1;
      s2 += j * j;
      s4 += j * j * j * j;
      y0 += y;
      y1 += j * y;
      y2 += j * j * y;
    }
    linear = y1 / s2;
    square = (s0 * y2 - s2 * y0) / (s0 * s4 - s2 * s2);
  }

  double slope(std::size_t i) const { return (linear + 2 * square * (static_cast<double>(i) - middle)) * kSpeedRateHz; }
};

void differentiate(std::vector<MotionSample>& samples) {
  const std::size_t window = std::min(kDerivativeWindow, samples.size());
  const std::size_t half = window / 2;
  const std::size_t last = samples.size() - window;  // first sample of the last window
  const Parabola begin(samples, 0, window);
  const Parabola end(samples, last, window);
  // In the middle of a window the parabola's slope is that of the straight line.
  double squares = 0;
  for (std::size_t j = 1; j <= half; ++j) squares += 2 * static_cast<double>(j * j);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (i < half) {
      samples[i].speed_mm_s = begin.slope(i);
    } else if (i > last + half || window < kDerivativeWindow) {
      samples[i].speed_mm_s = end.slope(i);
    } else {
      double sum = 0;
      for (std::size_t j = 1; j <= half; ++j) {
        sum += static_cast<double>(j) * (samples[i + j].depth_mm - samples[i - j].depth_mm);
      }
      samples[i].speed_mm_s = sum / squares * kSpeedRateHz;
    }
  }
}

}  // namespace

Result<Motion> speedFromPositions(std::span<const double> time_s, std::span<const double> depth_mm) {
  if (auto ok = checkPositions(time_s, depth_mm); !ok) return tl::unexpected(ok.error());
  Motion motion;
  motion.samples = resampled(time_s, depth_mm);
  if (motion.samples.size() < 3) {
    return fail(ErrorCode::kData, "positions", base::formatNumber(time_s.back() - time_s.front()) + " s of motion",
                "at least " + base::formatNumber(2 / kSpeedRateHz) + " s");
  }
  differentiate(motion.samples);
  for (std::size_t i = 1; i < time_s.size(); ++i) {
    if (time_s[i] - time_s[i - 1] > kLongestStepS + kTimeRoundingS) motion.gaps.push_back({time_s[i - 1], time_s[i]});
  }
  return motion;
}

std::span<const MotionSample> forwardPart(std::span<const MotionSample> samples, double above_mm_s) {
  const auto fast = [above_mm_s](const MotionSample& sample) { return sample.speed_mm_s > above_mm_s; };
  const auto first = std::find_if(samples.begin(), samples.end(), fast);
  const auto last = std::find_if(samples.rbegin(), samples.rend(), fast);
  if (first == samples.end()) return {};
  return {first, last.base()};
}

}  // namespace tactus::experiments
