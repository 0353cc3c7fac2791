// The text literals of a C++ source, with the calls that they stand in: read off the characters, without a compiler.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tactus::tests {

struct Literal {
  std::string text;  ///< as it is written, without the quotes
  std::size_t line = 0;
  /// Names before the open parentheses and braces around it, the nearest last: `QLabel`, `EditController::tr`. Empty
  /// where no name stands there.
  std::vector<std::string> calls;
};

/// The literals of `source` in their order. Left out: comments, characters, and lines of the preprocessor.
std::vector<Literal> literalsOf(std::string_view source);

}  // namespace tactus::tests
