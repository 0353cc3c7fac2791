// What a client of the live link may send, as a function of bytes; see fuzz_targets.h.
#pragma once

#include <string_view>

namespace tactus::fuzz {

/// A session answers or refuses in whole lines of UTF-8, and is refused once at most.
void fuzzLink(std::string_view bytes);

}  // namespace tactus::fuzz
