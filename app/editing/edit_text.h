// The words in which edits, rules and values are named: labels where the model has them, ids otherwise.
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

/// `value` to a ten-thousandth of the universe or a little finer, without zeros at the end: `62.5`.
std::string numberText(const fuzzy::Variable& variable, double value);
/// With its unit: `62.5 mm`; a ratio has none.
std::string quantityText(const fuzzy::Variable& variable, double value);

/// `IF Tube lubrication is Well AND Insertion depth is Stomach`, in the words of `expert`'s terms; an id that the model
/// does not have stands as it is.
std::string conditionsText(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, const fuzzy::Rule& rule);
/// The label of an output term as `expert` understands it, or `id`.
std::string consequentText(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, const std::string& id);

}  // namespace tactus::editing
