// What kind of edit a pull offers, and whether a person would take it seriously.
#pragma once

#include <cstddef>
#include <optional>

#include "core/analysis/pull/pull.h"
#include "core/analysis/pull/pull_edit.h"

namespace tactus::analysis {

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

}  // namespace tactus::analysis
