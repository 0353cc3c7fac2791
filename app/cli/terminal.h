// The terminal: wrapped text, a line of progress, typed lines, Ctrl-C.
#pragma once

#include <array>
#include <csignal>
#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>

namespace tactus::cli {

// Handles Ctrl-C while a device is in use, so that the program ends in order.

/// During its lifetime the first SIGINT or SIGTERM only sets a flag, which loops check; the second ends the program at
/// once. The destructor restores the previous handlers. One object at a time in a process.
class InterruptSignals {
 public:
  InterruptSignals();
  ~InterruptSignals();
  InterruptSignals(const InterruptSignals&) = delete;
  InterruptSignals& operator=(const InterruptSignals&) = delete;

  /// Thread: any.
  bool raised() const noexcept;

 private:
  static constexpr std::array kSignals = {SIGINT, SIGTERM};
  std::array<struct sigaction, kSignals.size()> before_{};
};

// Reads lines that a person types, without blocking the caller's loop.

/// Reads `in` line by line. For standard input it returns only what is already there and never waits; it bypasses
/// std::cin, so no other code may read from it. For any other stream it waits.
class TypedLines {
 public:
  /// `in` must outlive the object.
  explicit TypedLines(std::istream& in) : in_(in) {}

  /// The next line; nothing if there is none yet, or if `ended`.
  std::optional<std::string> next();
  /// Whether the input has ended.
  bool ended() const noexcept { return ended_; }

 private:
  std::optional<std::string> fromStandardInput();
  std::optional<std::string> takeLine();

  std::istream& in_;
  std::string waiting_;  ///< read from standard input, not returned yet
  bool ended_ = false;
};

// Sentences and tables on a terminal.

inline constexpr std::size_t kTextColumns = 100;

/// `sentence` (UTF-8), escaped by base::oneLine, in lines of at most kTextColumns characters, each with a line feed.
/// Lines break at spaces; a longer word stays whole. The first line starts with `first`, all others with `indent`
/// spaces.
std::string wrapped(std::string_view sentence, std::string_view first, std::size_t indent);

/// The number of characters of `text` (UTF-8) on the screen, one for each code point.
std::size_t characters(std::string_view text);

/// A cell of a table: `text` (UTF-8), escaped by base::oneLine, with spaces behind it up to `width` characters, and at
/// least `gap` spaces.
std::string padded(std::string_view text, std::size_t width, std::size_t gap = 1);

/// The same with the spaces before the text, for numbers.
std::string rightAligned(std::string_view text, std::size_t width, std::size_t gap = 1);

}  // namespace tactus::cli
