// The points at which a model states its forces: enough to catch a reader that gets something wrong.
#pragma once

#include <cstddef>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

inline constexpr std::size_t kLeastChecks = 2000;

/// Points for the table of checks, at least kLeastChecks: one in the core of each rule, both ends of every vertex of
/// the terms and the middles between them (where neighbors tie), inside and at the edges of each hole, outside each end
/// of each universe, where six ordinary mistakes of readers show most (wrong_readers.h), and random ones.
/// Deterministic. `model` must be valid.
std::vector<std::vector<double>> checkPoints(const fuzzy::ForceModel& model);

/// The forces at these points.
std::vector<fuzzy::Check> checksAt(const fuzzy::ForceModel& model, const std::vector<std::vector<double>>& points);

/// The few that the model file itself carries: those of rules, holes, universes and mistakes, at most `most`.
std::vector<fuzzy::Check> ownChecks(const fuzzy::ForceModel& model, std::size_t most = 400);

}  // namespace tactus::analysis
