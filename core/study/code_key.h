// Comparison keys for participant codes.
#pragma once

#include <string>
#include <string_view>

namespace tactus::study {

/// The key of a code: equal for codes that a reader takes for the same. It keeps lower-case letters and digits, and
/// drops leading zeros of numbers. `S1`, `s-01` and ` S 1` all give `s1`. Characters beyond ASCII stay, except Unicode
/// dashes and spaces.
std::string codeKey(std::string_view code);

}  // namespace tactus::study
