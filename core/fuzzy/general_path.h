// The general path: evaluation without the fast form (program.h). It accepts every model within the limits. Nothing
// outside core/fuzzy includes this.
#pragma once

#include <span>

#include "core/fuzzy/model_tables.h"

namespace tactus::fuzzy {

/// Memberships and strengths are multiplied by this power of two, so that small values and their products keep their
/// digits.
inline constexpr double kStrengthScale = 0x1p512;

/// The running weighted mean of the experts that fire (paper, Eq. 2).
struct Mean {
  double offset = 0;
  long double weights = 0;  ///< wide enough for the sum of all weights

  void add(double expert_offset, double weight) noexcept {
    weights += weight;
    // The mean stays between the smallest and the largest offset. A single offset comes out unchanged.
    offset += (expert_offset - offset) * static_cast<double>(weight / weights);
  }
  Evaluation result(const ModelTables& tables) const noexcept {
    if (weights == 0) return {tables.default_force_n, false};
    return {tables.output_min + offset, true};
  }
};

/// The mean at one point. `clamped`: finite inputs, each inside its universe.
/// Thread: any. Real-time safe: yes.
Evaluation evaluateGenerally(const ModelTables& tables, std::span<const double> clamped) noexcept;

/// The centroid of one expert. Returns false if the expert abstains. Otherwise `offset` is the centroid measured from
/// the lower end of the output universe.
/// Thread: any. Real-time safe: yes.
bool expertOffsetGenerally(const ModelTables& tables, std::size_t expert, std::span<const double> clamped,
                           double& offset) noexcept;

/// The aggregated strengths of one expert's output terms; see CompiledModel::strengths.
/// Thread: any. Real-time safe: yes.
bool expertStrengths(const ModelTables& tables, std::size_t expert, std::span<const double> clamped,
                     std::span<double> strengths) noexcept;

}  // namespace tactus::fuzzy
