// The models and points on which everything is compared.
#pragma once

#include <cstddef>
#include <gmpxx.h>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::bench {

/// Points of a benchmark, all inputs, both row by row and input by input.
struct Points {
  std::size_t inputs = 0;
  std::vector<double> rows;
  std::vector<std::vector<double>> columns;

  std::size_t count() const { return columns.front().size(); }
  std::span<const double> row(std::size_t point) const { return {rows.data() + point * inputs, inputs}; }
  void add(std::span<const double> point);
};

/// A model, points, and the exact forces at the first of them.
struct Case {
  std::string name;
  fuzzy::ForceModel model;
  fuzzy::CompiledModel compiled;
  std::vector<std::optional<double>> fixed;  ///< per input: its value at all points, or nothing
  Points points;
  std::vector<mpq_class> exact_n;   ///< forces at the first points, from exact rational arithmetic
  std::vector<double> one_point_n;  ///< CompiledModel::evaluate at all points
};

/// The four inputs of the NGT model and what the benchmark fixes where a scene is compared: a lubrication and a neck
/// flexion at which two terms each are active.
inline constexpr double kFixedLubrication = 0.7;
inline constexpr double kFixedNeckFlexionDeg = 65;
std::vector<std::optional<double>> sceneOfNgt();

/// 10,000 points, one in each cell of a 10 x 10 x 10 x 10 grid over the universes, shuffled; inputs that are fixed hold
/// their values. The same points every time.
Points shuffledPoints(const fuzzy::ForceModel& model, const std::vector<std::optional<double>>& fixed);

/// S4's printed rules with five depth terms, so that some rule fires everywhere.
fuzzy::ForceModel oneExpert(fuzzy::Implication implication);

/// The same expert and `count` - 1 synthetic variations: invented experts who differ from S4 in one or two steps of the
/// force in some rules. No person gave these answers. With `own_terms` every variation has terms of its own.
fuzzy::ForceModel syntheticExperts(int count, bool own_terms = false);

/// The case `name`; exact forces at the first `exact_points`.
Case makeCase(std::string name, fuzzy::ForceModel model, std::vector<std::optional<double>> fixed,
              std::size_t exact_points);

}  // namespace tactus::bench
