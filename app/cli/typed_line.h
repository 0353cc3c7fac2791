// Lines that a person types while something else goes on.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>

namespace tactus::cli {

/// The next line from `in`. From a keyboard: only one that is there already, so that a loop goes on meanwhile. From
/// anything else: waits for it. Nothing: no line yet. `ended`: there will be none any more.
std::optional<std::string> typedLine(std::istream& in, bool& ended);

}  // namespace tactus::cli
