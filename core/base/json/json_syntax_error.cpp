#include "core/base/json/json_syntax_error.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/base/ascii.h"
#include "core/base/text.h"

namespace tactus::base {
namespace {

struct Token {
  std::size_t begin = 0;
  std::size_t end = 0;
  bool string = false;
};

bool isOfWord(char c) {
  return isDigit(c) || isLetter(c) || isBeyondAscii(c) || c == '-' || c == '+' || c == '.' || c == '_';
}

/// Index after the string that begins at `begin`, or the end of the text.
std::size_t endOfString(std::string_view text, std::size_t begin) {
  std::size_t at = begin + 1;
  while (at < text.size() && text[at] != '"') at += text[at] == '\\' ? 2 : 1;
  return std::min(at + 1, text.size());
}

/// The last string, word, number or sign that begins at or before `last`.
Token tokenAt(std::string_view text, std::size_t last) {
  Token token;
  std::size_t at = 0;
  while ((at = text.find_first_not_of(" \t\r\n", at)) <= last) {
    token = {at, at + 1, text[at] == '"'};
    if (token.string) token.end = endOfString(text, at);
    while (isOfWord(text[at]) && token.end < text.size() && isOfWord(text[token.end])) ++token.end;
    at = token.end;
    if (at >= text.size()) break;
  }
  return token;
}

/// Whether the bytes up to `last`, with the whole character that begins or continues there, are not UTF-8.
bool isBrokenUtf8(std::string_view text, std::size_t last) {
  std::size_t end = last + 1;
  for (int more = 0; more < 3 && end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U; ++more)
    ++end;
  return !isUtf8(text.substr(0, end));
}

}  // namespace

std::string linePlace(std::string_view text, std::size_t at) {
  const std::string_view before = text.substr(0, at);
  const auto lines = std::count(before.begin(), before.end(), '\n');
  const std::string_view line = before.substr(before.rfind('\n') + 1);
  const auto characters =
      std::count_if(line.begin(), line.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
  return "line " + std::to_string(lines + 1) + ", column " + std::to_string(characters + 1);
}

Error syntaxError(std::string_view text, std::size_t position) {
  const auto error = [&](std::size_t at, std::string found, std::string wanted) {
    return Error{ErrorCode::kSyntax, {}, linePlace(text, at), std::move(found), std::move(wanted)};
  };
  if (position > text.size()) return error(text.size(), "the end of the text", "the rest of the JSON");
  const std::size_t last = position > 0 ? position - 1 : 0;
  if (isBrokenUtf8(text, last)) {
    std::size_t first = last;
    while (!isUtf8(text.substr(0, first))) --first;
    return error(first, "bytes that are not UTF-8", "JSON in UTF-8");
  }

  const Token token = tokenAt(text, last);
  if (token.string && last > token.begin && last + 1 < token.end) {
    if (static_cast<unsigned char>(text[last]) < 0x20) {
      return error(last, "the control character " + base::quoted(text.substr(last, 1)) + " in a string",
                   "an escape such as \\n, or the end of the string");
    }
    return error(last, "an unknown escape in a string", "one of \\\" \\\\ \\/ \\b \\f \\n \\r \\t \\uXXXX");
  }

  const std::string_view word = text.substr(token.begin, token.end - token.begin);
  const std::string plain = lowered(word.substr(word.find_first_not_of("+-") == 1 ? 1 : 0));
  if (plain.starts_with("nan") || plain.starts_with("inf")) {
    return error(token.begin, base::quoted(word), "a number: JSON has no NaN and no infinity");
  }
  const std::size_t before = text.substr(0, token.begin).find_last_not_of(" \t\r\n");
  if (before != std::string_view::npos && text[before] == ',' && (word == "]" || word == "}")) {
    return error(before, "a comma before " + base::quoted(word), "no comma after the last value");
  }
  return error(token.begin, token.string ? "the string " + base::quoted(word) : base::quoted(word), "correct JSON");
}

}  // namespace tactus::base
