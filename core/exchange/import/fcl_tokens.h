// The tokens of FCL: words, numbers and signs, without comments.
#pragma once

#include <vector>

#include "core/base/error.h"
#include "core/exchange/import/rule_parser.h"

namespace tactus::exchange {

/// All tokens of `source`. Comments are `(* *)`, `/* */`, `//` and `#` to the end of the line, and `%` at the beginning
/// of a line. `..` and `:=` are one sign each. Refused: a comment without an end.
base::Result<std::vector<Token>> fclTokens(const SourceText& source);

}  // namespace tactus::exchange
