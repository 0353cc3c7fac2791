// Eight ordinary mistakes of programs that read a model file, as functions. The checks of a model hold points at which
// they show.
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

/// A reader with one mistake.
struct WrongReader {
  std::string_view mistake;
  std::function<fuzzy::Evaluation(std::span<const double>)> force;
};

/// The readers whose mistake can matter for `model`: rule weights taken as 1, disabled rules read, inputs not clamped,
/// experts who abstain counted with the default force, experts weighted equally, the default force taken as 0,
/// memberships multiplied instead of the least one taken, experts of weight 0 who make the model fire.
/// `model` must be valid and outlives them.
std::vector<WrongReader> wrongReaders(const fuzzy::ForceModel& model);

}  // namespace tactus::analysis
