// The program `tactus` as a function, so that tests can run it.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace tactus::cli {

/// Runs `tactus` with `arguments` (without the program's name). Results go to `out`, one line per warning or error to
/// `err`. Returns the exit status: 0 fine, 1 wrong input or a failed verification, 2 wrong usage.
/// Commands that talk with a person read from `in`, without it from standard input.
int run(std::vector<std::string> arguments, std::ostream& out, std::ostream& err);
int run(std::vector<std::string> arguments, std::istream& in, std::ostream& out, std::ostream& err);

}  // namespace tactus::cli
