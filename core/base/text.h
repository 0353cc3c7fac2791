// Numbers and text, independent of the locale.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace tactus::base {

// Finds the known word that a mistyped word probably means.

/// The number of letters to insert, remove, replace, or swap with their neighbor to turn `a` into `b`. Ignores case
/// (optimal string alignment, Damerau 1964).
std::size_t editDistance(std::string_view a, std::string_view b);

/// The element of `known` nearest to `word`, the first of equals. It may differ by at most a third of the letters of
/// `word`, and at most 3. Empty if no element is that close.
std::string closestWord(std::string_view word, std::span<const std::string> known);

/// ` (slow?)` for the closest known word, to append to an error; empty if there is none.
std::string suggestion(std::string_view word, std::span<const std::string> known);

// Text for XML, HTML and SVG.

/// `text` with the five special characters of XML escaped. Control characters but tab and line feed, and bytes that are
/// not UTF-8, become U+FFFD: the document stays well-formed for any data.
std::string xmlEscaped(std::string_view text);

// Numbers in notes for the user.

/// `value` rounded to four decimals, without trailing zeros: 0.15 for 0.15000000000000002. Writes a number in full if
/// rounding would hide its digits (not 0 and below 0.001, or at least a million).
std::string roundedNumber(double value);

// Lists of outside names in messages.

/// Outside names for a message: quoted (error.h), separated by commas. After about 200 bytes, `…` replaces the rest.
std::string listed(std::span<const std::string> names);

// Replacing parts of a text.

/// `text` with each `from` of a pair replaced by its `to`, one pair after another. A `from` is not empty; what a `to`
/// puts in is not replaced by the same pair.
std::string replaced(std::string text, std::initializer_list<std::pair<std::string_view, std::string_view>> pairs);

// Kinds of characters, the same in every locale.

inline bool isDigit(char c) { return c >= '0' && c <= '9'; }
/// Of the English alphabet.
inline bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
/// A byte of a character outside ASCII, in UTF-8.
inline bool isBeyondAscii(char c) { return (static_cast<unsigned char>(c) & 0x80U) != 0; }

/// The shortest text that reads back as the same double (`std::to_chars`); "nan", "inf" or "-inf" for the others.
std::string formatNumber(double value);

/// `value` with `decimals` digits after the point, rounded to nearest. For display only, never for files that are read
/// back.
std::string formatFixed(double value, int decimals);

/// The double in `text` (`std::from_chars`; also nan and inf). Nothing unless the whole text is a number. No spaces, no
/// plus sign.
std::optional<double> parseNumber(std::string_view text) noexcept;

/// The integer in `text`. Nothing unless the whole text is an integer.
std::optional<long long> parseInteger(std::string_view text) noexcept;

/// A character at the start of a text.
struct Utf8Character {
  char32_t code = 0;      ///< 0 if the first byte does not start a well-formed character
  std::size_t bytes = 1;  ///< its length, 1 to 4; 1 for such a byte
  bool valid = false;
};

/// The first character of `text`, which must not be empty (RFC 3629: no surrogates, no overlong forms).
Utf8Character firstCharacter(std::string_view text) noexcept;

/// Whether `text` is well-formed UTF-8.
bool isUtf8(std::string_view text) noexcept;

/// Whether a terminal or a screen could treat the character as a command instead of a letter: C0, DEL, C1, writing
/// direction controls, line and paragraph separators.
bool isControl(char32_t code) noexcept;

/// `text` without spaces and tabs at both ends.
std::string_view trimmed(std::string_view text) noexcept;

/// `text` with ASCII letters in lower case; all other characters unchanged.
std::string lowered(std::string_view text);

/// `parts`, separated by `separator`.
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
