// Kinds of characters, the same in every locale.
#pragma once

namespace tactus::base {

inline bool isDigit(char c) { return c >= '0' && c <= '9'; }
/// Of the English alphabet.
inline bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
/// A byte of a character outside ASCII, in UTF-8.
inline bool isBeyondAscii(char c) { return (static_cast<unsigned char>(c) & 0x80U) != 0; }

}  // namespace tactus::base
