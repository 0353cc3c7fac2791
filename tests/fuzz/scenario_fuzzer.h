// A scenario file as a function of bytes; see fuzz_targets.h.
#pragma once

#include <string_view>

namespace tactus::fuzz {

/// A scenario that is read ends in time, and its events follow each other.
void fuzzScenario(std::string_view bytes);

}  // namespace tactus::fuzz
