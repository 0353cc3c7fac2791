// The difference between the averaged forces of two models with the same inputs.
#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/analysis/lint.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

// What differs between two models: variables, terms, experts, rules, settings. (The newtons: force_difference.h.)

struct ModelChange {
  enum class Kind { kAdded, kRemoved, kChanged };

  Kind kind = Kind::kChanged;
  std::string place;   ///< e.g. `term 'slow' of 'speed'`, `rule of S4: lubrication poor, depth stomach`
  std::string before;  ///< empty for what was added
  std::string after;   ///< empty for what was removed

  bool operator==(const ModelChange&) const = default;
};

/// `added`, `removed`, `changed`.
std::string_view name(ModelChange::Kind kind) noexcept;

/// All differences that can change the force or how it is felt, in the order of the first model; labels, dates, checks
/// and origin are left out. Terms, experts and variables are known by their ids, rules by their conditions.
std::vector<ModelChange> modelChanges(const fuzzy::ForceModel& first, const fuzzy::ForceModel& second);

// The range of forces of a model, found by sampling.

/// Evaluates every combination of the vertices of all terms and their midpoints. If there are more than 20,000, it
/// evaluates 20,000 points of a Halton sequence over them, fewer if the model has many rules. Deterministic. Ends soon
/// after `stop` is requested and returns the range found so far.
ForceRange reachableRange(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                          const std::stop_token& stop = {});

// Points spread over the whole input space, at which two models or two experts are compared.

/// Enough for a root mean square that no longer depends on the points in its third digit.
inline constexpr std::size_t kBoxPoints = 4'096;

/// `count` points of the Halton sequence (1960), from its first on, one value per input, scaled to the universes.
/// The same points for the same universes. They weigh the input space evenly, whatever is used of it in practice.
std::vector<std::vector<double>> boxPoints(const fuzzy::ForceModel& model, std::size_t count = kBoxPoints);

/// The points of one input's whole range, both ends included, with the other inputs at their values in `at`.
std::vector<std::vector<double>> linePoints(const fuzzy::ForceModel& model, const std::vector<double>& at,
                                            std::size_t input, std::size_t count);

struct ForceDifference {
  double largest_n = 0;    ///< largest |difference| found
  std::vector<double> at;  ///< its point; empty if the forces are equal
  double first_n = 0;      ///< force of the first model there, then of the second
  double second_n = 0;
  double rms_n = 0;                ///< over points spread evenly over the universes of the inputs
  std::size_t points = 0;          ///< points of both kinds at which both models fired
  std::size_t only_one_fires = 0;  ///< points at which exactly one model fires
};

/// Searches the largest difference at combinations of the first model's vertices and midpoints, and the root mean
/// square at evenly spread points. Uses fewer points if the models have many rules. Skips points where one model does
/// not fire. `first` and `second`: valid, with the same number of inputs. Deterministic.
ForceDifference forceDifference(const fuzzy::ForceModel& first, const fuzzy::CompiledModel& compiled_first,
                                const fuzzy::ForceModel& second, const fuzzy::CompiledModel& compiled_second);

}  // namespace tactus::analysis
