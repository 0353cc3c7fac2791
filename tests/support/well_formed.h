// A small check that markup is well-formed: tags nest, attributes are quoted, text is escaped. For tests.
#pragma once

#include <string>
#include <string_view>

namespace tactus::support {

/// What is wrong with `markup` (XML, or HTML written as XML), with the place; empty if nothing is. Knows elements,
/// attributes, comments, CDATA, a document type, and the entities amp, lt, gt, quot, apos and character references.
std::string markupFault(std::string_view markup);

/// How often `part` occurs in `text`, without overlaps.
std::size_t countOf(std::string_view text, std::string_view part);

}  // namespace tactus::support
