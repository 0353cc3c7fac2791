// A JSON text on one line.
#pragma once

#include <string>
#include <string_view>

namespace tactus::link {

/// `json`, which must be valid, without its byte order mark and without white space between tokens. Strings, digits and
/// the order of keys stay byte for byte, so the result reads as the same model.
std::string compactJson(std::string_view json);

}  // namespace tactus::link
