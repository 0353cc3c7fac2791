// What an edit comes to: the force it gives, what it moves elsewhere, and whether it is plausible.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/analysis/pull/elsewhere.h"
#include "core/analysis/pull/pull.h"
#include "core/analysis/pull/pull_edit.h"

namespace tactus::analysis {

// What kind of edit a pull offers, and whether a person would take it seriously.

/// The part of `model` that a pull sees: the expert number `expert` alone, or the mean of those with a weight.
fuzzy::ForceModel modelOf(const fuzzy::ForceModel& model, std::optional<std::size_t> expert);

/// Refuses a pin that is no point of the model (checkPoint), or at which no rule of `compiled` fires.
base::Result<void> checkPins(const fuzzy::CompiledModel& compiled, const fuzzy::ForceModel& model,
                             std::span<const std::vector<double>> pins);

/// `asked`, else the input `depth`, else the last input.
std::size_t curveInput(const fuzzy::ForceModel& model, std::optional<std::size_t> asked);

PullKind kindOf(const fuzzy::ForceModel& model, const PullEdit& edit, std::size_t curve_input);

/// False for a rule moved by two or more words, or against the direction of its expert's other rules, and for a force
/// word moved by more than half of its width at half height. `after`: `model` after the edit.
bool isPlausible(const fuzzy::ForceModel& model, const fuzzy::ForceModel& after, const PullEdit& edit);

class CandidateJudge {
 public:
  /// `model`: the part that is pulled (candidate_judge.h); it stays where it is as long as this object. `compiled`:
  /// made from it.
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
