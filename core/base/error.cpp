#include "core/base/error.h"

#include <utility>

#include "core/base/text.h"

namespace tactus::base {
namespace {

/// The first `most_bytes` of `text`, cut at a whole UTF-8 character.
std::string shortened(std::string_view text, std::size_t most_bytes) {
  if (text.size() <= most_bytes) return std::string(text);
  std::size_t end = most_bytes;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return std::string(text.substr(0, end)) + "…";
}

/// The lowest `digits` hexadecimal digits of `code` behind a backslash and `kind`.
void escape(std::string& out, char kind, char32_t code, int digits) {
  constexpr std::string_view kHex = "0123456789abcdef";
  out += '\\';
  out += kind;
  for (int digit = digits - 1; digit >= 0; --digit) out += kHex[(code >> (4U * static_cast<unsigned>(digit))) & 15U];
}

std::string escaped(std::string_view text, bool keeps_lines) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const Utf8Character character = firstCharacter(text);
    if (!character.valid) {
      escape(out, 'x', static_cast<unsigned char>(text.front()), 2);
    } else if (!isControl(character.code) || (keeps_lines && character.code == '\n')) {
      out += text.substr(0, character.bytes);
    } else if (character.code < 0x80) {
      escape(out, 'x', character.code, 2);
    } else {
      escape(out, 'u', character.code, 4);
    }
    text.remove_prefix(character.bytes);
  }
  return out;
}

}  // namespace

std::string_view describe(ErrorCode code) noexcept {
  switch (code) {
    case ErrorCode::kIo: return "a file or folder cannot be read or written";
    case ErrorCode::kSyntax: return "the text is not of its format";
    case ErrorCode::kSchema: return "something is missing, doubled or of the wrong type";
    case ErrorCode::kValue: return "a value is outside what its place allows";
    case ErrorCode::kReference: return "a name refers to nothing";
    case ErrorCode::kLimit: return "a limit is exceeded";
    case ErrorCode::kVersion: return "the file is newer than this program";
    case ErrorCode::kMismatch: return "a verification failed";
    case ErrorCode::kData: return "the data do not determine an answer";
    case ErrorCode::kCancelled: return "stopped before the end";
  }
  return "unknown error";
}

std::string Error::message() const {
  constexpr std::size_t kLongestPlace = 300;  // a place may carry a key of any length
  std::string text;
  if (!file.empty()) text += file + ": ";
  if (!place.empty()) text += shortened(place, kLongestPlace) + ": ";
  text += "found " + found + ", wanted " + wanted;
  return oneLine(text);
}

tl::unexpected<Error> fail(ErrorCode code, std::string place, std::string found, std::string wanted) {
  return tl::unexpected(Error{code, {}, std::move(place), std::move(found), std::move(wanted)});
}

tl::unexpected<Error> inFile(Error error, std::string_view file) {
  if (error.file.empty()) error.file = file;
  return tl::unexpected(std::move(error));
}

std::string oneLine(std::string_view text) { return escaped(text, false); }

std::string plainLines(std::string_view text) { return escaped(text, true); }

std::string quoted(std::string_view text) { return "'" + oneLine(shortened(text, 60)) + "'"; }

}  // namespace tactus::base
