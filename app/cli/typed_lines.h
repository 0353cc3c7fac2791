// Lines that a person types while something else goes on.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>

namespace tactus::cli {

/// Reads `in` line by line. Of standard input only what is there already, so that a loop goes on meanwhile; it is read
/// past the stream, so nothing else may read from it. Any other stream is waited for.
class TypedLines {
 public:
  /// `in` must outlive the object.
  explicit TypedLines(std::istream& in) : in_(in) {}

  /// The next line; nothing: no line yet, or `ended`.
  std::optional<std::string> next();
  /// There will be no line any more.
  bool ended() const noexcept { return ended_; }

 private:
  std::optional<std::string> fromStandardInput();
  std::optional<std::string> takeLine();

  std::istream& in_;
  std::string waiting_;  ///< read from standard input, not yet handed out
  bool ended_ = false;
};

}  // namespace tactus::cli
