// SHA-256 of a text: says whether two texts are the same byte for byte.
#pragma once

#include <string>
#include <string_view>

namespace tactus::base {

/// SHA-256 (FIPS 180-4) of `bytes`, 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace tactus::base
