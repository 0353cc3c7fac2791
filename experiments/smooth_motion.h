// A stretch of hand movement without its tremor: a smooth curve fitted to positions, with its derivative.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace tactus::experiments {

/// Positions = smooth movement + one sinusoid of 7 to 13 Hz + white noise.
///
/// The movement is a cubic spline whose third differences are penalised (Eilers and Marx 1996), less where the movement
/// is rough, as it is at the ends of a quick stroke: roughness and fit are found in turn. The sinusoid, whose amplitude
/// and phase may drift linearly, has an amplitude of about 0.2 mm, so tremor (8 to 12 Hz) goes there and not into the
/// curve. Penalty, frequency and the best of six starts are those of the largest restricted likelihood (REML; Patterson
/// and Thompson 1971). The fit looks at both sides of each point alike: it has no delay. It takes about 10 ms.
class SmoothMotion {
 public:
  /// Fits to positions at equal steps of `step_s`, 1 to 12 ms; at least kFewestPositions, at most a few hundred, each
  /// within 1e6 mm.
  SmoothMotion(std::span<const double> positions_mm, double step_s);

  static constexpr std::size_t kFewestPositions = 20;

  /// Speed of the movement without tremor, at `time_s` from the first position; clamped to the stretch.
  double speedMmS(double time_s) const;
  /// Its position.
  double positionMm(double time_s) const;

 private:
  std::vector<double> coefficients_;
  double knot_s_;
  double length_s_;
  double offset_mm_;
};

}  // namespace tactus::experiments
