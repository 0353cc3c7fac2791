// Whether a force model makes sense.
#pragma once

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"

namespace tactus::fuzzy {

/// The first thing that is wrong with `model`, or success. The error's place is a pointer (RFC 6901) into the model
/// file, e.g. `/experts/0/rules/3/then`. Checked: the limits, ids (present, unique in their list, at most 64 bytes),
/// universes and points (finite, at most 1e150 in size, in order), output terms (they meet the universe in positive
/// width), rules (known inputs and terms, each input once, weight in [0, 1], no rule twice in one expert), weights
/// (finite, >= 0, one > 0), the renderer's ranges. The values of `checks` are compared by model_io.
base::Result<void> validate(const ForceModel& model);

}  // namespace tactus::fuzzy
