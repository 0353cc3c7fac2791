// Codes of participants as people compare them.
#pragma once

#include <string>
#include <string_view>

namespace tactus::study {

/// What two codes share that a person takes for one: small letters and digits only, numbers without leading zeros.
/// `S1`, `s-01` and ` S 1` all give `s1`; other characters than ASCII stay, but for dashes and spaces of Unicode.
std::string codeKey(std::string_view code);

}  // namespace tactus::study
