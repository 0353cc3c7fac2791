// Newton's first step towards the centers of drawn strokes, without a pass over their samples (part of
// stroke_bootstrap.h).
#pragma once

#include <span>
#include <vector>

#include "elicitation/speed/stroke_resampling.h"

namespace tactus::elicitation {

/// The sums of a clustering at fixed centers, stroke by stroke. Those of drawn strokes are their sum, each as often as
/// it was drawn.
class StrokeSums {
 public:
  StrokeSums() = default;
  /// `centres`: of all strokes, scaled as `strokes` has them, ascending. Leaves `strokes` with every stroke taken once.
  StrokeSums(StrokeResampler& strokes, std::span<const double> centres, double m);

  /// Where Newton's step leads from the centers; the centers themselves if it leads far or out of the data.
  std::vector<double> firstStep(std::span<const std::vector<double>> times);

 private:
  std::vector<double> centres_;
  double longest_ = 0;                                  // that a step may be
  std::vector<std::vector<std::vector<double>>> sums_;  // level, stroke: pull, then curvature (FcmSums)
  std::vector<double> matrix_, step_;                   // scratch
};

}  // namespace tactus::elicitation
