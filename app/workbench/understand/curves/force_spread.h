// How far the experts lie apart along a curve.
#pragma once

#include <span>
#include <vector>

#include "app/workbench/model/force_curves.h"

namespace tactus::workbench {

/// One value per position of the curves; NaN where too few experts have a rule.
struct ForceSpread {
  std::vector<double> lowest_n;  ///< of the experts who have a rule there; two at least
  std::vector<double> highest_n;
  std::vector<double> deviation_n;  ///< one standard deviation; three experts at least
  std::vector<double> minus_sd_n;   ///< the mean less that
  std::vector<double> plus_sd_n;
};

/// The weights of the experts, in their order.
std::vector<double> weightsOf(const fuzzy::ForceModel& model);

/// Experts from which on a standard deviation says something.
inline constexpr std::size_t kFewestForDeviation = 3;

/// The range and the standard deviation around the mean. The deviation has the weights of the experts as the mean has,
/// without bias for equal weights (n - 1): s^2 = sum w (F - mean)^2 / (sum w - sum w^2 / sum w). No distribution is
/// assumed and no quartiles are taken: those of four experts would be numbers between two of them. `weights`: one per
/// expert, >= 0; an expert with the weight 0 counts as absent, as in the mean.
ForceSpread spreadOf(const ForceCurves& curves, std::span<const double> weights);

}  // namespace tactus::workbench
