// Force along one input while the other inputs stay fixed: the numbers behind the force-depth curves.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/analysis/force_steps.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::figures {

/// Evenly spaced samples of a curve, in addition to the vertices of the terms: one for two pixels of a plot 1000 px
/// wide.
inline constexpr std::size_t kCurveSamples = 513;
/// The same for a model with more than `kManyExperts` experts. All kinks lie at vertices, and every curve is smooth
/// between them.
inline constexpr std::size_t kCurveSamplesOfMany = 129;
inline constexpr std::size_t kManyExperts = 32;

/// The force of every expert and of the mean at the positions `x` of one input.
struct ForceCurves {
  std::vector<double> x;                                ///< ascending, in the unit of the input
  std::vector<fuzzy::Evaluation> mean;                  ///< one per position
  std::vector<std::vector<fuzzy::Evaluation>> experts;  ///< one list per expert
};

struct Interval {
  double low = 0;
  double high = 0;
};

/// The sample positions of input `x_input`: even over its universe, and as many over the part `shown` if it is smaller;
/// at every vertex of its term lists, and at the two floating-point neighbors of each vertex. So kinks, jumps and the
/// ends of gaps are exact.
std::vector<double> samplePositions(const fuzzy::ForceModel& model, std::size_t x_input,
                                    std::optional<Interval> shown = std::nullopt);

/// The curves along `x_input` at these positions. `values` has one value per input; the value of `x_input` is not used.
ForceCurves computeCurves(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled, std::size_t x_input,
                          std::span<const double> values, std::optional<Interval> shown = std::nullopt);

/// Steps of the force along `x_input` that a hand on a device notices, or that are steeper than the renderer's spring.
/// Empty if the output is not a force in newtons, or for a model with more than `kManyExperts` experts.
std::vector<analysis::ForceStep> noticeableSteps(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                                                 std::size_t x_input, std::span<const double> values);

/// The intervals without a firing rule: of positive width, between samples that did not fire.
std::vector<Interval> silentIntervals(std::span<const double> x, std::span<const fuzzy::Evaluation> curve);

}  // namespace tactus::figures
