// Draws whole strokes of one participant within each level, in a form that is fast to cluster again.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/random.h"
#include "core/study/records.h"

namespace tactus::elicitation {

/// Samples within a stroke are not independent, so an interval must draw strokes, not samples. Strokes are stored as
/// histograms of kBins bins over the range of all samples, each bin with its mean. The error is of second order in the
/// bin width: below 0.001 mm/s of a center for speeds of 0 to 500 mm/s.
class StrokeResampler {
 public:
  static constexpr std::size_t kBins = 512;

  /// `samples`: of one participant, all finite, at least two different speeds, each of a level in `levels`.
  StrokeResampler(std::span<const study::SpeedSample> samples, std::span<const std::string> levels);

  /// The first level with fewer than two strokes: its index and its number of strokes. Nothing if every level has two.
  std::optional<std::pair<std::size_t, std::size_t>> levelWithoutChoice() const;

  /// Draws as many strokes as each level has, with replacement.
  void draw(base::Random& random);
  /// Takes every stroke once.
  void takeAll();
  /// Takes one stroke once and no other (indices from 0).
  void takeOnly(std::size_t level, std::size_t stroke);
  /// Takes every stroke once except this one (indices from 0).
  void leaveOut(std::size_t level, std::size_t stroke);
  /// The number of strokes of each level.
  std::vector<std::size_t> strokeCounts() const;
  /// How often each stroke of each level is taken.
  std::span<const std::vector<double>> times() const { return times_; }

  /// The samples of the drawn strokes, ascending, scaled to [-1, 1], and the number of samples that each represents.
  std::span<const double> values() const { return values_; }
  std::span<const double> weights() const { return weights_; }
  double toScaled(double speed_mm_s) const { return (speed_mm_s - middle_mm_s_) / half_range_mm_s_; }
  double toOriginal(double scaled) const { return middle_mm_s_ + half_range_mm_s_ * scaled; }
  /// The lowest of all samples, in mm/s.
  double lowest() const { return toOriginal(-1); }

  /// The mean of each level's samples in the drawn strokes, in mm/s, exact. Every level must have strokes.
  std::vector<double> levelMeans() const;

 private:
  struct StrokeBins {
    double count = 0;
    double sum = 0;                    // of scaled speeds
    std::size_t first = 0;             // bin of its lowest speed
    std::vector<double> counts, sums;  // of each bin from there to that of its highest speed
  };

  void collect();

  double middle_mm_s_ = 0;
  double half_range_mm_s_ = 1;
  std::vector<std::vector<StrokeBins>> levels_;
  std::vector<std::vector<double>> times_;   // number of draws of each stroke
  std::vector<double> bin_count_, bin_sum_;  // scratch
  std::vector<double> values_, weights_;
};

}  // namespace tactus::elicitation
