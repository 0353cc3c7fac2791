// The likelihood of a smooth movement with tremor for given positions: the inner part of smooth_motion.h.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "experiments/band_matrix.h"

namespace tactus::experiments {

inline constexpr double kKnotS = 0.012;  // between knots: resolves ramps of 30 ms; the penalty smooths shorter details
inline constexpr std::size_t kSplineOrder = 4;    // cubic
inline constexpr std::size_t kTremorColumns = 4;  // sine and cosine, and their linear change

/// The four non-zero cubic B-splines at `u` in [0, 1] between two knots.
std::array<double, kSplineOrder> splineValues(double u);

/// A value for each tremor column.
using TremorRow = std::array<double, kTremorColumns>;

/// The part of the normal equations that belongs to a sinusoid of one frequency.
struct TremorEquations {
  std::vector<TremorRow> with_splines;  ///< products with each spline
  BandMatrix<kTremorColumns> among{kTremorColumns};
  TremorRow right{};
};

/// Normal equations of the spline, which all frequencies share, and of a sinusoid of each frequency.
struct MotionEquations {
  /// `noise_mm`: standard deviation of each position. The tremor has its usual amplitude as a prior, so that the
  /// sinusoid cannot replace the movement.
  MotionEquations(std::span<const double> positions_mm, double step_s, double offset_mm, std::span<const double> hz,
                  std::size_t spline_count, double noise_mm);

  BandMatrix<kSplineOrder> splines;
  std::vector<std::array<double, 1>> right;  ///< for each spline
  std::vector<TremorEquations> tremors;      ///< one for each frequency
  double squares_mm2 = 0;
  double positions = 0;
};

/// The fit of maximum likelihood among the tried penalties and frequencies.
struct MotionFit {
  double unlikelihood = std::numeric_limits<double>::infinity();  ///< -2 log of the restricted likelihood
  std::size_t frequency = 0;                                      ///< its index
  int penalty = 0;                                                ///< exponent of 10
  std::vector<double> coefficients;                               ///< of the splines
};

/// The most likely fit over all frequencies and penalties. `rough`: relative roughness of the movement at each third
/// difference of the coefficients. `near`: if given, only neighbors of this fit are tried.
MotionFit likeliestMotion(const MotionEquations& equations, std::span<const double> rough,
                          const MotionFit* near = nullptr);

/// The roughness of a movement at each third difference of its coefficients, relative to the mean, at least 1e-4.
std::vector<double> roughness(std::span<const double> coefficients);

}  // namespace tactus::experiments
