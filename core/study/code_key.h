// Comparison keys for participant codes.
#pragma once

#include <string>
#include <string_view>

namespace tactus::study {

/// The key of a code. Codes that a person reads as the same one have the same key. It keeps lower-case letters and
/// digits, and drops leading zeros of numbers. `S1`, `s-01` and ` S 1` all give `s1`. Characters beyond ASCII stay,
/// except Unicode dashes and spaces.
std::string codeKey(std::string_view code);

}  // namespace tactus::study
