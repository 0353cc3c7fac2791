// What a force-feedback device says of itself and sends, as a function of bytes; see fuzz_targets.h.
#pragma once

#include <string_view>

namespace tactus::fuzz {

/// A report descriptor, and the same bytes once more as input reports. A layout that is found holds its values: what is
/// put into a report is taken out of it again, and no sample has a number that is none.
void fuzzHid(std::string_view bytes);

}  // namespace tactus::fuzz
