// The names of edits, rules and values in words: labels if the model has them, ids otherwise.
#pragma once

#include <string>

#include "core/fuzzy/force_model.h"

namespace tactus::editing {

std::string labelOf(const fuzzy::Variable& variable);
std::string labelOf(const fuzzy::Term& term);
std::string labelOf(const fuzzy::Expert& expert);

/// `left foot`, `left shoulder`, `right shoulder`, `right foot`; `left foot`, `peak`, `right foot`; `mean`, `sigma`.
/// `point` is below fuzzy::pointCount(shape).
std::string pointName(fuzzy::Shape shape, std::size_t point);

/// `value` to 1/10,000 of the universe or a little finer, without trailing zeros: `62.5`.
std::string numberText(const fuzzy::Variable& variable, double value);
/// The number with its unit: `62.5 mm`; a ratio has none.
std::string quantityText(const fuzzy::Variable& variable, double value);

/// `IF Tube lubrication is Well AND Insertion depth is Stomach`, with the labels of the terms of `expert`. An id that
/// the model does not have stays as it is.
std::string conditionsText(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, const fuzzy::Rule& rule);
/// The label of an output term in the list of `expert`; `id` if there is none.
std::string consequentText(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, const std::string& id);

}  // namespace tactus::editing
