// Reads a form from its data file, and the study's form embedded in the program.
#pragma once

#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/study/records.h"
#include "questionnaires/aliases.h"

namespace tactus::questionnaires {

/// Reads a form (JSON, see forms/ngt_force_v1.json) from `text`; `file` is its name in errors. `aliases` gives the
/// condition of each item from its wording. Returns an error for: an unknown word, a duplicate item number, an item
/// that does not ask for the output, two items with the same condition, no items.
base::Result<study::Form> parseForm(std::string_view text, const std::string& file, const AliasTable& aliases);

/// The 45 items of Table A1 in the paper's order and wording, id `ngt-force-v1`.
study::Form ngtForceForm();

}  // namespace tactus::questionnaires
