#include "app/cli/terminal.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <iostream>
#include <poll.h>
#include <unistd.h>
#include <utility>

#include "core/base/error.h"

namespace tactus::cli {
namespace {

// A signal handler gets no argument of ours, so its flag has to be global.
std::atomic<bool> g_raised{false};
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void onSignal(int number) {
  if (!g_raised.exchange(true)) return;
  // Takes effect when this handler returns: until then the signal is blocked.
  std::signal(number, SIG_DFL);
  std::raise(number);
}

}  // namespace

InterruptSignals::InterruptSignals() {
  g_raised = false;
  struct sigaction action {};
  action.sa_handler = onSignal;
  sigemptyset(&action.sa_mask);
  for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &action, &before_[i]);
}

InterruptSignals::~InterruptSignals() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &before_[i], nullptr);
}

bool InterruptSignals::raised() const noexcept { return g_raised.load(); }

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

namespace {

std::string spacesBeside(std::string_view cell, std::size_t width, std::size_t gap) {
  const std::size_t taken = characters(cell);
  return std::string(std::max(width, taken + gap) - taken, ' ');
}

}  // namespace

std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string wrapped(std::string_view sentence, std::string_view first, std::size_t indent) {
  const std::string harmless = base::oneLine(sentence);
  std::string_view text = harmless;
  std::string out(first);
  std::size_t column = characters(first);
  bool line_start = true;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::size_t needed = characters(word) + (line_start ? 0 : 1);
    if (!line_start && column + needed > kTextColumns) {
      out += '\n' + std::string(indent, ' ');
      column = indent;
      line_start = true;
    }
    if (!line_start) out += ' ';
    out += word;
    column += characters(word) + (line_start ? 0 : 1);
    line_start = false;
  }
  return out + '\n';
}

std::string padded(std::string_view text, std::size_t width, std::size_t gap) {
  const std::string cell = base::oneLine(text);
  return cell + spacesBeside(cell, width, gap);
}

std::string rightAligned(std::string_view text, std::size_t width, std::size_t gap) {
  const std::string cell = base::oneLine(text);
  return spacesBeside(cell, width, gap) + cell;
}

}  // namespace tactus::cli
