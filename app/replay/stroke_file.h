// A file of strokes that are given by their depths, speeds and conditions: regression strokes. docs/tell.md.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/contracts/telling_stroke.h"
#include "core/fuzzy/force_model.h"

namespace tactus::replay {

struct NamedStroke {
  std::string name;
  contracts::Stroke stroke;
};

/// The text of a file with strokes of `model`.
std::string formatStrokes(const fuzzy::ForceModel& model, const std::vector<NamedStroke>& strokes);

/// The strokes in `text` for `model`; `file` is its name in errors. Refused: a condition that `model` does not have,
/// an input of it without a value, a stroke that does not go inward.
base::Result<std::vector<NamedStroke>> parseStrokes(const fuzzy::ForceModel& model, std::string_view text,
                                                    const std::string& file);

}  // namespace tactus::replay
