// Names to indices, checked on the way. Nothing outside core/fuzzy includes this.
#pragma once

#include <array>

#include "core/fuzzy/model_checks.h"
#include "core/fuzzy/model_tables.h"

namespace tactus::fuzzy {

/// Names of a model's variables and of their own terms; the output comes after the inputs.
struct ModelNames {
  NameList variables;
  std::array<NameList, kMostInputs + 1> terms;
};

/// Everything that `validate` checks. The experts and their rules are appended to `tables`, over indices: enabled rules
/// with a weight > 0 only. Which banks they refer to is left open.
Problem resolve(const ForceModel& model, ModelTables& tables);

/// The part of it for experts; the variables of the model are known to be right, and have these names.
Problem resolveExperts(const ForceModel& model, const ModelNames& names, ModelTables& tables);

}  // namespace tactus::fuzzy
