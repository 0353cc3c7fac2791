// Reads a form from its data file, and the form of the study that the program carries.
#pragma once

#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/study/records.h"
#include "questionnaires/aliases.h"

namespace tactus::questionnaires {

/// Reads a form (JSON, see forms/ngt_force_v1.json) from `text`, said to be of `file` in errors. The condition of each
/// item comes from its wording through `aliases`. Refused: an unknown word, an item number twice, an item that does not
/// ask for the output, two items about the same condition, no items.
base::Result<study::Form> parseForm(std::string_view text, const std::string& file, const AliasTable& aliases);

/// The 45 items of Table A1 in the paper's order and wording, id `ngt-force-v1`.
study::Form ngtForceForm();

}  // namespace tactus::questionnaires
