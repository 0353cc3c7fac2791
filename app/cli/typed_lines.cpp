#include "app/cli/typed_lines.h"

#include <array>
#include <cerrno>
#include <iostream>
#include <poll.h>
#include <unistd.h>
#include <utility>

namespace tactus::cli {

std::optional<std::string> TypedLines::next() {
  if (&in_ == &std::cin) return fromStandardInput();
  std::string line;
  if (std::getline(in_, line)) return line;
  ended_ = true;
  return std::nullopt;
}

std::optional<std::string> TypedLines::fromStandardInput() {
  while (true) {
    if (auto line = takeLine()) return line;
    pollfd input{STDIN_FILENO, POLLIN, 0};
    if (ended_ || ::poll(&input, 1, 0) <= 0) return std::nullopt;
    std::array<char, 512> room;
    const ssize_t count = ::read(STDIN_FILENO, room.data(), room.size());
    if (count < 0 && errno == EINTR) return std::nullopt;
    if (count > 0) {
      waiting_.append(room.data(), static_cast<std::size_t>(count));
      continue;
    }
    ended_ = true;
    if (!waiting_.empty()) return std::exchange(waiting_, {});
  }
}

std::optional<std::string> TypedLines::takeLine() {
  const auto end = waiting_.find('\n');
  if (end == std::string::npos) return std::nullopt;
  std::string line = waiting_.substr(0, end);
  waiting_.erase(0, end + 1);
  return line;
}

}  // namespace tactus::cli
