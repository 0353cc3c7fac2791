// Runs another program, without a shell, with its input and output in files.
#pragma once

#include <stop_token>
#include <string>
#include <vector>

namespace tactus::bundle {

enum class Ran {
  kNotThere,  ///< no such program
  kEnded,     ///< by the limit of time, or by a request to stop
  kFailed,    ///< with another exit status than 0
  kWell,
};

/// Runs the program `words[0]`, found in PATH. It reads the file `in` of `folder` and writes `out` and, for its errors,
/// `err` there.
Ran runProgram(std::vector<std::string> words, const std::string& folder, const std::stop_token& stop = {});

}  // namespace tactus::bundle
