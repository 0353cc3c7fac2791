#include "app/cli/typed_line.h"

#include <iostream>
#include <poll.h>
#include <unistd.h>

namespace tactus::cli {
namespace {

bool waitsForKeyboard(std::istream& in) {
  if (&in != &std::cin || ::isatty(STDIN_FILENO) == 0) return false;
  pollfd keyboard{STDIN_FILENO, POLLIN, 0};
  return ::poll(&keyboard, 1, 0) == 0;
}

}  // namespace

std::optional<std::string> typedLine(std::istream& in, bool& ended) {
  if (waitsForKeyboard(in)) return std::nullopt;
  std::string line;
  if (std::getline(in, line)) return line;
  ended = true;
  return std::nullopt;
}

}  // namespace tactus::cli
