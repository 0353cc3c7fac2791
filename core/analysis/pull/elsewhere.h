// How much else an edit moves: the common currency in which edits of millimeters, degrees and words compare.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/analysis/expert_spread.h"
#include "core/base/error.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

/// Differences of the force after an edit. k_curve and k_box are root mean squares of the difference over the
/// noticeable difference around the force before; points without a force before or after are left out.
struct Elsewhere {
  double k = 0;             ///< sqrt(k_curve^2 / 2 + k_box^2 / 2); k_curve if the box was not asked for
  double k_curve = 0;       ///< along one input at the place of the pull
  double k_box = 0;         ///< over the whole input space
  double largest_n = 0;     ///< the largest difference at these points
  bool opens_hole = false;  ///< a point that had a force has none
};

/// The points, and the forces before.
class ElsewhereProbe {
 public:
  /// The curve has 601 points over the range of `curve_input` at `point` (one for each mm of the paper's depths), the
  /// box `box_points` of `boxPoints`, none for 0. `compiled`: made from `model`.
  ElsewhereProbe(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled, const std::vector<double>& point,
                 std::size_t curve_input, std::size_t box_points, const NoticeableDifference& noticeable);

  /// `after`: the model after the edit, over the same inputs.
  Elsewhere of(const fuzzy::CompiledModel& after) const;

 private:
  struct Forces {
    std::vector<double> force_n;
    std::vector<std::uint8_t> fired;
  };
  Forces forces(const fuzzy::CompiledModel& model) const;

  std::vector<std::vector<double>> columns_;  ///< one per input
  std::size_t curve_points_ = 0;
  Forces before_;
  std::vector<double> noticeable_n_;
};

/// The force of `compiled` (or the hole) at many points given by columns.
void evaluateColumns(const fuzzy::CompiledModel& compiled, const std::vector<std::vector<double>>& columns,
                     std::span<double> force_n, std::span<std::uint8_t> fired);

}  // namespace tactus::analysis
