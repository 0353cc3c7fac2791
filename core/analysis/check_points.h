// The points at which a model states its forces: enough to catch a reader that gets something wrong.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

// Eight ordinary mistakes of programs that read a model file, as functions. The checks of a model hold points at which
// they show.

/// A reader with one mistake.
struct WrongReader {
  std::string_view mistake;
  std::function<fuzzy::Evaluation(std::span<const double>)> force;
};

/// The readers whose mistake can matter for `model`: rule weights taken as 1, disabled rules read, inputs not clamped,
/// experts who abstain counted with the default force, experts weighted equally, the default force taken as 0,
/// memberships multiplied instead of the least one taken, experts of weight 0 who make the model fire.
/// `model` must be valid and outlives them.
std::vector<WrongReader> wrongReaders(const fuzzy::ForceModel& model);

inline constexpr std::size_t kLeastChecks = 2000;

/// Points for the table of checks, at least kLeastChecks: one in the core of each rule, both ends of every vertex of
/// the terms and the middles between them (where neighbors tie), inside and at the edges of each hole, outside each end
/// of each universe, where six ordinary mistakes of readers show most (check_points.h), and random ones.
/// Deterministic. `model` must be valid.
std::vector<std::vector<double>> checkPoints(const fuzzy::ForceModel& model);

/// The forces at these points.
std::vector<fuzzy::Check> checksAt(const fuzzy::ForceModel& model, const std::vector<std::vector<double>>& points);

/// The few that the model file itself carries: those of rules, holes, universes and mistakes, at most `most`.
std::vector<fuzzy::Check> ownChecks(const fuzzy::ForceModel& model, std::size_t most = 400);

}  // namespace tactus::analysis
