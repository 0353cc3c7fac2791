#include "core/base/files/name_removal.h"

#include <algorithm>

#include "core/base/text.h"

namespace tactus::base {
namespace {

// Fewer bytes are often part of an ordinary word.
constexpr std::size_t kShortestInWords = 4;

bool isWord(char c) { return isDigit(c) || isLetter(c) || isBeyondAscii(c); }

bool isSmall(char c) { return c >= 'a' && c <= 'z'; }

/// Whether a hyphen and a small letter beside a name make another code of it, as `calm` in `calm-fox`.
bool isHalfACode(std::string_view before, std::string_view name, std::string_view after) {
  if (!std::all_of(name.begin(), name.end(), isSmall)) return false;
  if (after.size() > 1 && after[0] == '-' && isSmall(after[1])) return true;
  return before.size() > 1 && before.back() == '-' && isSmall(before[before.size() - 2]);
}

/// Whether `name`, which stands at `at`, stands there as a name.
bool isName(std::string_view text, std::size_t at, std::string_view name) {
  if (at > 0 && isWord(text[at - 1]) && isWord(name.front())) return false;
  const std::string_view rest = text.substr(at + name.size());
  if (isHalfACode(text.substr(0, at), name, rest)) return false;
  if (rest.empty() || !isWord(name.back())) return true;
  if (isDigit(rest.front())) return false;
  if (rest.size() > 1 && rest.front() == '-' && isDigit(rest[1])) return false;
  return name.size() >= kShortestInWords || (!isLetter(rest.front()) && !isBeyondAscii(rest.front()));
}

/// The length of the longest name that stands at `at`, or 0.
std::size_t nameAt(std::string_view text, std::size_t at, std::span<const std::string> names) {
  std::size_t longest = 0;
  for (const std::string& name : names) {
    if (name.size() <= longest || !text.substr(at).starts_with(name)) continue;
    if (isName(text, at, name)) longest = name.size();
  }
  return longest;
}

}  // namespace

bool holdsName(std::string_view text, std::span<const std::string> names) {
  for (const std::string& name : names) {
    if (name.empty()) continue;
    for (auto at = text.find(name); at != std::string_view::npos; at = text.find(name, at + 1)) {
      if (isName(text, at, name)) return true;
    }
  }
  return false;
}

std::string withoutNames(std::string_view text, std::span<const std::string> names) {
  if (!holdsName(text, names)) return std::string(text);
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = nameAt(text, at, names);
    if (length > 0) {
      out += kRemovedName;
      at += length;
    } else {
      out += text[at++];
    }
  }
  return out;
}

}  // namespace tactus::base
