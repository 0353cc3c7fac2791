// The spread of the experts along a curve.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "app/figures/force_curves.h"
#include "app/workbench/base/plot_table.h"

namespace tactus::workbench {

// The curves as a table.

class SceneController;

/// The visible lines, which are the columns of the table.
struct ShownCurves {
  bool mean = true;
  std::vector<bool> experts;  ///< one per expert
  std::vector<bool> family;   ///< one per value of the family, if there is one
  bool range = false;         ///< range of the experts; two columns
  bool deviation = false;     ///< one standard deviation of the experts
};

/// The x axis, then one column for each visible line; a cell is empty if no rule fires. `notes` go into the caption.
PlotTable curveTable(const SceneController& scene, const ShownCurves& shown, QStringList notes);

// Finds curves of experts that lie on each other, so that none of them hides the others.

/// The place of a curve among those that it coincides with.
struct Coincidence {
  std::size_t member = 0;  ///< from 0
  std::size_t of = 1;      ///< how many lie on each other; 1: the curve is alone

  bool operator==(const Coincidence&) const = default;
};

/// One per expert. Two curves coincide where both fire and differ by at most `within_n`, if they do so over a tenth of
/// the axis or more. Of more than twelve experts none is looked at: their colors repeat anyway.
std::vector<Coincidence> coincidences(const figures::ForceCurves& curves, double within_n);

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
