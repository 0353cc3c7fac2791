// A hand movement without its tremor: a smooth curve fitted to positions, and its derivative.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace tactus::experiments {

/// Positions = smooth movement + one sinusoid of 7 to 13 Hz + white noise.
///
/// The movement is a cubic spline with a penalty on its third differences (Eilers and Marx 1996). The penalty is
/// smaller where the movement is rough, as at the ends of a quick stroke; roughness and fit are computed alternately.
/// The sinusoid has an amplitude of about 0.2 mm; its amplitude and phase may drift linearly. So it absorbs the tremor
/// (8 to 12 Hz). Penalty, frequency and the best of six starts are chosen by the largest restricted likelihood (REML;
/// Patterson and Thompson 1971). The fit uses both sides of each point equally, so it has no delay. It takes about
/// 2 ms.
class SmoothMotion {
 public:
  /// Fits `positions_mm`, at equal steps of `step_s` (1 to 12 ms): from kFewestPositions to a few hundred positions,
  /// each within 1e6 mm.
  SmoothMotion(std::span<const double> positions_mm, double step_s);

  static constexpr std::size_t kFewestPositions = 20;

  /// Speed of the movement without tremor, `time_s` after the first position. Times outside the stretch are clamped.
  double speedMmS(double time_s) const;
  /// Position of the movement without tremor at the same time.
  double positionMm(double time_s) const;

 private:
  std::vector<double> coefficients_;
  double knot_s_;
  double length_s_;
  double offset_mm_;
};

}  // namespace tactus::experiments
