// The program `tactus` as a function, so that tests can run it.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace tactus::cli {

/// Runs `tactus` with `arguments` (without the program's name). Results go to `out`; each warning or error is one line
/// in `err`. Returns the exit status: 0 success, 1 wrong input or failed verification, 2 wrong usage. A dialog reads
/// from `in`; without `in` from standard input.
int run(std::vector<std::string> arguments, std::ostream& out, std::ostream& err);
int run(std::vector<std::string> arguments, std::istream& in, std::ostream& out, std::ostream& err);

}  // namespace tactus::cli
