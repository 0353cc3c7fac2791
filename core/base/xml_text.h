// Text for XML, HTML and SVG.
#pragma once

#include <string>
#include <string_view>

namespace tactus::base {

/// `text` with the five special characters of XML escaped. Control characters but tab and line feed, and bytes that are
/// not UTF-8, become U+FFFD: the document stays well-formed for any data.
std::string xmlEscaped(std::string_view text);

}  // namespace tactus::base
