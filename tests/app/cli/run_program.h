// Runs `tactus` inside the test and keeps what it says.
#pragma once

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "app/cli/program.h"

namespace tactus::cli {

struct ProgramRun {
  int status;
  std::string out, err;

  explicit ProgramRun(const std::vector<std::string>& arguments) {
    std::ostringstream out_stream;
    std::ostringstream err_stream;
    status = run(arguments, out_stream, err_stream);
    out = out_stream.str();
    err = err_stream.str();
  }
};

inline std::string readText(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// `text` with the line breaks inside of sentences (those before spaces) taken out.
inline std::string unwrapped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == ' ' && !out.empty() && (out.back() == '\n' || out.back() == ' ')) {
      out.back() = ' ';
    } else {
      out += c;
    }
  }
  return out;
}

inline void writeText(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

}  // namespace tactus::cli
