// The forces along one line through the input space, at the places where they can change suddenly. Internal to the
// search for steps.
#pragma once

#include <compare>
#include <optional>
#include <span>
#include <vector>

#include "core/analysis/force_steps.h"

namespace tactus::analysis {

/// Finds the places along one input beside which the force can change suddenly.
class StepPlaces {
 public:
  StepPlaces(const fuzzy::ForceModel& model, std::size_t input);

  /// With the other inputs as in `point`: both sides of each kink of the strengths and places within `stepWidth` of it;
  /// with `even`, also places half that width apart over the universe. Ascending, inside the universe.
  std::vector<double> at(std::span<const double> point, bool even) const;

  const fuzzy::Variable& variable() const noexcept { return model_.inputs[input_]; }
  double width() const noexcept { return width_; }
  /// Places of a line without kinks between flanks.
  std::size_t usualCount() const noexcept { return kPlacesOfAKink * fixed_.size(); }

 private:
  static constexpr std::size_t kPlacesOfAKink = 7;

  /// A straight piece of a membership times the weight of a rule: 0 at `foot`, `top` at `shoulder`.
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
  std::vector<Flank> flanks_;  ///< of the terms of `input` in rules, each once
};

/// One force along the line.
struct LineForce {
  std::vector<double> x;        ///< where it fires, ascending
  std::vector<double> force_n;  ///< one for each
  std::vector<int> piece;       ///< places with the same number have the same experts firing, and so has all between
};

/// Two places of a line.
struct LinePair {
  std::size_t from = 0;
  std::size_t to = 0;
  double noticeable = 0;  ///< of the limits; > 1 is a step
  bool steep = false;     ///< steeper than the limits allow
};

/// The pairs of places at most `width` apart whose forces differ by `least` noticeable differences or more, or too
/// steeply where `in_mm`; of those that overlap, each with the next, the largest. Ascending.
std::vector<LinePair> stepsOn(const LineForce& line, double width, bool in_mm, const StepLimits& limits, double least);

}  // namespace tactus::analysis
