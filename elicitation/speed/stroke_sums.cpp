#include "elicitation/speed/stroke_sums.h"

#include <algorithm>
#include <cmath>

#include "elicitation/clustering/fcm_data.h"
#include "elicitation/clustering/fcm_pass.h"
#include "elicitation/clustering/positive_solve.h"

namespace tactus::elicitation {
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

}  // namespace tactus::elicitation
