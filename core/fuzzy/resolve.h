// Turns names into indices and checks them. Nothing outside core/fuzzy includes this.
#pragma once

#include <array>

#include "core/fuzzy/model_checks.h"
#include "core/fuzzy/model_tables.h"

namespace tactus::fuzzy {

/// The ids of a model's variables and of their own terms. The output follows the inputs.
struct ModelNames {
  NameList variables;
  std::array<NameList, kMostInputs + 1> terms;
};

/// Does all checks of `validate`. Appends the experts to `tables`, with those of their rules that are enabled and have
/// a weight > 0. The bank indices of the experts are not set.
Problem resolve(const ForceModel& model, ModelTables& tables);

/// Does this for the experts only. The variables of `model` are valid, and `names` holds their ids.
Problem resolveExperts(const ForceModel& model, const ModelNames& names, ModelTables& tables);

}  // namespace tactus::fuzzy
