// The spread of the experts along a curve.
#pragma once

#include <span>
#include <vector>

#include "app/figures/force_curves.h"

namespace tactus::workbench {

/// One value per position of the curves; NaN if too few experts have a rule there.
struct ForceSpread {
  std::vector<double> lowest_n;  ///< of the experts who have a rule there; at least two
  std::vector<double> highest_n;
  std::vector<double> deviation_n;  ///< one standard deviation; at least three experts
  std::vector<double> minus_sd_n;   ///< the mean minus deviation_n
  std::vector<double> plus_sd_n;
};

/// The smallest number of experts for which a standard deviation is meaningful.
inline constexpr std::size_t kFewestForDeviation = 3;

/// The range, and the standard deviation around the mean. The deviation uses the experts' weights like the mean does,
/// and is unbiased for equal weights (n - 1): s^2 = sum w (F - mean)^2 / (sum w - sum w^2 / sum w). It assumes no
/// distribution. There are no quartiles: for four experts they would lie between two values. `weights`: one per expert
/// (normalizedWeights); an expert with weight 0 is left out, as in the mean.
ForceSpread spreadOf(const figures::ForceCurves& curves, std::span<const double> weights);

}  // namespace tactus::workbench
