// Who signed off a model, so that an edit of it contradicts them.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"

namespace tactus::cli {

struct SignOff {
  std::string author;
  std::string text;  ///< `feels right, after 3 edits: 4 strokes on Touch`
  std::string utc;   ///< `2026-11-21T08:00:00Z`
};

/// The sign-offs in the history of the study file `path` on a state with the terms, rules and settings of `model`, from
/// the oldest. When it was written, by which program, its provenance and checks do not count.
base::Result<std::vector<SignOff>> signOffsOn(fuzzy::ForceModel model, const std::string& path);

}  // namespace tactus::cli
