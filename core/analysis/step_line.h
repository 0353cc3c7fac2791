// The forces along one line through the input space, at the positions where they can change abruptly. Internal to the
// search for steps.
#pragma once

#include <compare>
#include <optional>
#include <span>
#include <vector>

#include "core/analysis/force_steps.h"

namespace tactus::analysis {

/// Finds the positions along one input at which the force can change abruptly.
class StepPlaces {
 public:
  StepPlaces(const fuzzy::ForceModel& model, std::size_t input);

  /// The positions for the other inputs as in `point`: both sides of each kink of the strengths, and positions within
  /// `stepWidth` of it. `even`: also positions half that width apart over the universe. Ascending, inside the universe.
  std::vector<double> at(std::span<const double> point, bool even) const;

  const fuzzy::Variable& variable() const noexcept { return model_.inputs[input_]; }
  double width() const noexcept { return width_; }
  /// Number of positions of a line without crossings of flanks.
  std::size_t usualCount() const noexcept { return kPlacesOfAKink * fixed_.size(); }

 private:
  static constexpr std::size_t kPlacesOfAKink = 7;

  /// A straight piece of a membership, times the weight of its rule: 0 at `foot`, `top` at `shoulder`.
  struct Flank {
    double foot = 0;
    double shoulder = 0;
    double top = 1;

    auto operator<=>(const Flank&) const = default;
  };

  std::vector<double> constants(std::span<const double> point) const;

  const fuzzy::ForceModel& model_;
  std::size_t input_;
  double width_;
  std::vector<double> fixed_;  ///< vertices and crossings of flanks
  std::vector<Flank> flanks_;  ///< of the terms of `input` in rules, without duplicates
};

/// The forces of one expert, or the mean, along the line.
struct LineForce {
  std::vector<double> x;        ///< positions with a force, ascending
  std::vector<double> force_n;  ///< the force at each position
  std::vector<int> piece;       ///< number of the piece; on one piece the same experts fire everywhere
};

/// Two positions of a line, by index.
struct LinePair {
  std::size_t from = 0;
  std::size_t to = 0;
  double noticeable = 0;  ///< in units of StepLimits::noticeable; > 1 is a step
  bool steep = false;     ///< steeper than the limits allow
};

/// The pairs of positions at most `width` apart with a step between: the forces differ by at least `least` noticeable
/// differences, or, if `in_mm`, too steeply. Of pairs that overlap in a chain it returns the largest. Ascending.
std::vector<LinePair> stepsOn(const LineForce& line, double width, bool in_mm, const StepLimits& limits, double least);

}  // namespace tactus::analysis
