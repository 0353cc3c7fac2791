// Validation of a force model.
#pragma once

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"

namespace tactus::fuzzy {

/// Returns the first error in `model`, or success. The place of the error is a JSON pointer (RFC 6901) into the model
/// file, e.g. `/experts/0/rules/3/then`. Checks:
/// - the limits of force_model.h;
/// - ids: present, unique in their list, at most 64 bytes;
/// - roles: at most one way and one rate among the inputs;
/// - universes and points: finite, at most 1e150 in size, in order;
/// - output terms: overlap the universe in positive width;
/// - rules: known inputs and terms, each input once, weight in [0, 1], no rule twice in one expert;
/// - weights: finite, >= 0, at least one > 0;
/// - the ranges of the renderer parameters;
/// - events: each on a term of the way, each term once, shares in (0, 1).
/// model_io compares the values of `checks`.
base::Result<void> validate(const ForceModel& model);

}  // namespace tactus::fuzzy
