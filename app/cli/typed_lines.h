// Reads lines that a person types, without blocking the caller's loop.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>

namespace tactus::cli {

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

}  // namespace tactus::cli
