// Names to indices, checked on the way. Nothing outside core/fuzzy includes this.
#pragma once

#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/model_tables.h"

namespace tactus::fuzzy {

/// Everything that `validate` checks. The rules of each expert are appended to `experts`, over indices: enabled rules
/// with a weight > 0 only. Which banks they refer to is left open.
base::Result<void> resolve(const ForceModel& model, std::vector<RuleTable>& experts);

/// The part of it for experts; the variables of the model are known to be right.
base::Result<void> resolveExperts(const ForceModel& model, std::vector<RuleTable>& experts);

}  // namespace tactus::fuzzy
