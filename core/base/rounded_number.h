// Numbers in notes for the user.
#pragma once

#include <string>

namespace tactus::base {

/// `value` rounded to four decimals, without trailing zeros: 0.15 for 0.15000000000000002. Writes a number in full if
/// rounding would hide its digits (not 0 and below 0.001, or at least a million).
std::string roundedNumber(double value);

}  // namespace tactus::base
