#include "core/base/error.h"

#include <utility>

namespace tactus::base {
namespace {

/// The first `most_bytes` of `text`, cut at a whole UTF-8 character.
std::string shortened(std::string_view text, std::size_t most_bytes) {
  if (text.size() <= most_bytes) return std::string(text);
  std::size_t end = most_bytes;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return std::string(text.substr(0, end)) + "…";
}

}  // namespace

std::string_view describe(ErrorCode code) noexcept {
  switch (code) {
    case ErrorCode::kIo:
      return "a file or folder cannot be read or written";
    case ErrorCode::kSyntax:
      return "the text is not of its format";
    case ErrorCode::kSchema:
      return "something is missing, doubled or of the wrong type";
    case ErrorCode::kValue:
      return "a value is outside what its place allows";
    case ErrorCode::kReference:
      return "a name refers to nothing";
    case ErrorCode::kLimit:
      return "a limit is exceeded";
    case ErrorCode::kVersion:
      return "the file is newer than this program";
    case ErrorCode::kMismatch:
      return "a verification failed";
    case ErrorCode::kData:
      return "the data do not determine an answer";
    case ErrorCode::kCancelled:
      return "stopped before the end";
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

std::string oneLine(std::string_view text) {
  constexpr std::string_view kHex = "0123456789abcdef";
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7F) {
      out += "\\x";
      out += kHex[byte >> 4U];
      out += kHex[byte & 15U];
    } else {
      out += c;
    }
  }
  return out;
}

std::string quoted(std::string_view text) { return "'" + oneLine(shortened(text, 60)) + "'"; }

}  // namespace tactus::base
