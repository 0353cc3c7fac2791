// What an edit comes to: the force it gives, what it moves elsewhere, and whether it is plausible.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/analysis/pull/elsewhere.h"
#include "core/analysis/pull/pull.h"

namespace tactus::analysis {

class CandidateJudge {
 public:
  /// `model`: the part that is pulled (plausible.h); it stays where it is as long as this object. `compiled`: made from
  /// it.
  CandidateJudge(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled, const std::vector<double>& point,
                 const NoticeableDifference& noticeable, const PullSettings& settings);

  std::size_t curveInput() const noexcept { return curve_input_; }

  /// The candidate that makes the edits one after the other. Nothing if it opens a hole, moves a pin or makes no valid
  /// model.
  /// Without `target_n` no force is exact.
  std::optional<PullCandidate> judged(std::vector<PullEdit> edits, std::optional<double> target_n) const;

  /// Forces that differ by less are the same: the rounding of a delta.
  double same() const noexcept;

 private:
  struct Pin {
    std::vector<double> point;
    double force_n = 0;    ///< before
    double allowed_n = 0;  ///< largest difference
  };
  bool holdsPins(const fuzzy::CompiledModel& after) const;

  const fuzzy::ForceModel& model_;
  std::vector<Pin> pins_;
  std::vector<double> point_;
  std::size_t curve_input_;
  ElsewhereProbe elsewhere_;
};

}  // namespace tactus::analysis
