// The names and numbers of a model as the commands print them.
#pragma once

#include <cstddef>
#include <string>

#include "core/fuzzy/force_model.h"

namespace tactus::cli {

/// `+0.086 N`, `-0.010 N`.
std::string signedNewtons(double newtons);

/// `60.000 deg`; without a unit for a share. Three digits after the point.
std::string withUnit(double number, const fuzzy::Variable& variable);

/// The label of a term, `id` without one; escaped. `term` may be null.
std::string labelOf(const fuzzy::Term* term, const std::string& id);

/// The label of the output term `id` in the shared list.
std::string wordLabel(const fuzzy::ForceModel& model, const std::string& id);

std::string variableLabel(const fuzzy::Variable& variable);

/// `Lubrication Well, Insertion depth Laryngopharynx`: the conditions of rule number `rule` of expert number `expert`.
std::string conditionsOf(const fuzzy::ForceModel& model, std::size_t expert, std::size_t rule);

}  // namespace tactus::cli
