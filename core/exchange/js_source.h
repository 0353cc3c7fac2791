// A model as plain JavaScript without any library: its terms and rules as data, and the exact centroid over them.
#pragma once

#include <string>

#include "core/exchange/origin.h"
#include "core/fuzzy/force_model.h"

namespace tactus::exchange {

/// force_model.js, a module for Node and a script for a page. Its forces agree with the evaluator to 1e-12 of the
/// output's range, `fired` exactly. The functions take another model in the shape of FORCE_MODEL too, which holds the
/// checksum of the `origin`. `model` must be valid.
std::string jsForce(const fuzzy::ForceModel& model, const Origin& origin = {});

}  // namespace tactus::exchange
