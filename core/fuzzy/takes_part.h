// Which rules of a model count.
#pragma once

#include "core/fuzzy/force_model.h"

namespace tactus::fuzzy {

/// Whether `rule` can fire: it is enabled and has a weight.
inline bool takesPart(const Rule& rule) { return rule.enabled && rule.weight > 0; }

}  // namespace tactus::fuzzy
