// Numbers in notes for people.
#pragma once

#include <string>

namespace tactus::base {

/// `value` rounded to four decimals, without zeros at the end: 0.15 for 0.15000000000000002. A number whose digits that
/// would hide (not 0 and below 0.001, or from a million) is written in full.
std::string roundedNumber(double value);

}  // namespace tactus::base
