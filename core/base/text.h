// Numbers and text, the same whatever the locale.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace tactus::base {

/// Shortest text that reads back as the same double (`std::to_chars`); "nan", "inf", "-inf" where there is no number.
std::string formatNumber(double value);

/// `value` with `decimals` digits after the point, rounded to nearest. For people only, never for files that are read
/// back.
std::string formatFixed(double value, int decimals);

/// The double that the whole of `text` says (`std::from_chars`; also nan and inf), or nothing. No spaces, no plus sign.
std::optional<double> parseNumber(std::string_view text) noexcept;

/// The integer that the whole of `text` says, or nothing.
std::optional<long long> parseInteger(std::string_view text) noexcept;

/// A character at the beginning of some text.
struct Utf8Character {
  char32_t code = 0;      ///< 0 where the first byte begins no well-formed character
  std::size_t bytes = 1;  ///< its length, 1 to 4; 1 for such a byte
  bool valid = false;
};

/// The first character of `text`, which is not empty (RFC 3629: no surrogates, no overlong forms).
Utf8Character firstCharacter(std::string_view text) noexcept;

/// Whether `text` is well-formed UTF-8.
bool isUtf8(std::string_view text) noexcept;

/// Whether a terminal or a screen could take the character for an order instead of a letter: C0, DEL, C1, the controls
/// of the writing direction, and the separators of lines and paragraphs.
bool isControl(char32_t code) noexcept;

/// `text` without spaces and tabs at both ends.
std::string_view trimmed(std::string_view text) noexcept;

/// ASCII letters in lower case, everything else as it is.
std::string lowered(std::string_view text);

/// `parts` with `separator` between them.
template <class Parts>
std::string joined(const Parts& parts, std::string_view separator) {
  std::string out;
  for (const auto& part : parts) {
    if (!out.empty()) out += separator;
    out += part;
  }
  return out;
}

}  // namespace tactus::base
