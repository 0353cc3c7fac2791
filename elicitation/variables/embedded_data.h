// The data files of this folder as the program carries them (tactus_embed).
#pragma once

#include <string_view>

namespace tactus::elicitation {

/// data/ngt_variables.json
std::string_view ngtVariablesJson();

}  // namespace tactus::elicitation
