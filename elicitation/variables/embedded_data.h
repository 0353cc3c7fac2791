// The data files of this folder, embedded in the program (tactus_embed).
#pragma once

#include <string_view>

namespace tactus::elicitation {

/// data/ngt_variables.json
std::string_view ngtVariablesJson();

}  // namespace tactus::elicitation
