// Rules as text, one a line, to copy and paste them as a block:
//   IF Tube lubrication is Well AND Insertion depth is Stomach THEN Resistive force is Small WITH 0.5
//   OFF IF Speed is Fast THEN Resistive force is Large
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"

namespace tactus::editing {

/// The rules `indices` of `expert`, with the labels of the model. A weight other than 1 follows behind WITH; a disabled
/// rule begins with OFF. `rulesFromText` reads the same rules again.
std::string rulesAsText(const fuzzy::ForceModel& model, const fuzzy::Expert& expert,
                        std::span<const std::size_t> indices);

/// Reads such text: labels or ids, in any case, with any spaces between the words; empty lines are skipped. One line
/// that is no rule refuses all of them, and the error names the line and what it does not know.
base::Result<std::vector<fuzzy::Rule>> rulesFromText(const fuzzy::ForceModel& model, const fuzzy::Expert& expert,
                                                     std::string_view text);

}  // namespace tactus::editing
