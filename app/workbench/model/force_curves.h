// Force along one input while the others stay: the numbers behind the force-depth curves.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/analysis/force_steps.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

/// Evenly spaced samples of a curve; the vertices of the terms come on top. More than the pixels of two mm on a screen.
inline constexpr std::size_t kCurveSamples = 513;
/// The same for a model of more than `kManyExperts`: the kinks lie at vertices, and between them every curve is smooth.
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

/// Where to sample input `x_input`: evenly over its universe, at every vertex of every term list of it, and at the
/// neighboring numbers of each vertex, so that kinks, jumps and the ends of gaps are exact.
std::vector<double> samplePositions(const fuzzy::ForceModel& model, std::size_t x_input);

/// The curves along `x_input`; `values` holds one value per input, that of `x_input` is not used.
ForceCurves computeCurves(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled, std::size_t x_input,
                          std::span<const double> values);

/// Steps of the force along `x_input` that a hand on a device notices or that are steeper than the renderer's spring;
/// none where the output is no force in newtons, or for a model of more than `kManyExperts`.
std::vector<analysis::ForceStep> noticeableSteps(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                                                 std::size_t x_input, std::span<const double> values);

/// Where no rule fires: the intervals of positive width between samples that did not fire.
std::vector<Interval> silentIntervals(std::span<const double> x, std::span<const fuzzy::Evaluation> curve);

}  // namespace tactus::workbench
