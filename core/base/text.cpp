#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <vector>

#include "core/base/error.h"

#ifndef __cpp_lib_to_chars
#include <cerrno>
#include <clocale>
#include <cstdlib>
#ifdef __APPLE__
#include <xlocale.h>
#endif
#endif

namespace tactus::base {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

}  // namespace

std::string xmlEscaped(std::string_view text) {
  const bool utf8 = isUtf8(text);
  std::string out;
  out.reserve(text.size());
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      case '\'': out += "&#39;"; break;
      case '\t':
      case '\n': out += c; break;
      default:
        if (byte < 0x20 || byte == 0x7F || (byte >= 0x80 && !utf8)) {
          out += kReplacement;
        } else {
          out += c;
        }
    }
  }
  return out;
}

std::string roundedNumber(double value) {
  const double size = std::abs(value);
  if (!(size >= 1e-3 && size < 1e6)) return formatNumber(value);
  std::string text = formatFixed(value, 4);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

std::string listed(std::span<const std::string> names) {
  constexpr std::size_t kLongestList = 200;
  std::string text;
  for (const auto& name : names) {
    text += (text.empty() ? "" : ", ") + base::quoted(name);
    if (text.size() > kLongestList && &name != &names.back()) return text + ", …";
  }
  return text;
}

std::string formatNumber(double value) {
  if (std::isnan(value)) return "nan";
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

std::string formatFixed(double value, int decimals) {
  if (!std::isfinite(value)) return formatNumber(value);
  std::array<char, 400> buffer{};
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals).ptr;
  return {buffer.data(), end};
}

#ifdef __cpp_lib_to_chars
std::optional<double> parseNumber(std::string_view text) noexcept {
  double value = 0;
  const char* const last = text.data() + text.size();
  const auto [end, status] = std::from_chars(text.data(), last, value);
  if (end != last || text.empty()) return std::nullopt;
  if (status == std::errc::result_out_of_range) return std::nullopt;
  return value;
}
#else
// libc++ before 20 has no std::from_chars for double. strtod takes a plus, white space and hexadecimal digits, too.
std::optional<double> parseNumber(std::string_view text) noexcept {
  const std::string_view digits = text.substr(text.starts_with('-') ? 1 : 0);
  if (digits.empty() || std::string_view(".0123456789iInN").find(digits.front()) == std::string_view::npos)
    return std::nullopt;
  if (digits.size() > 1 && (digits[1] == 'x' || digits[1] == 'X')) return std::nullopt;
  static const locale_t kPlain = newlocale(LC_ALL_MASK, "C", nullptr);
  const std::string ended(text);
  char* end = nullptr;
  errno = 0;
  const double value = strtod_l(ended.c_str(), &end, kPlain);
  if (end != ended.c_str() + ended.size()) return std::nullopt;
  if (errno == ERANGE && (value == 0 || std::isinf(value))) return std::nullopt;
  return value;
}
#endif

std::optional<long long> parseInteger(std::string_view text) noexcept {
  long long value = 0;
  const char* const last = text.data() + text.size();
  const auto [end, status] = std::from_chars(text.data(), last, value);
  if (end != last || text.empty() || status != std::errc{}) return std::nullopt;
  return value;
}

Utf8Character firstCharacter(std::string_view text) noexcept {
  const auto lead = static_cast<unsigned char>(text.front());
  if (lead < 0x80) return {lead, 1, true};
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || length > text.size()) return {};
  char32_t code = lead & (0xFFU >> (length + 1));
  for (std::size_t k = 1; k < length; ++k) {
    const auto next = static_cast<unsigned char>(text[k]);
    if ((next & 0xC0U) != 0x80U) return {};
    code = (code << 6U) | (next & 0x3FU);
  }
  const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (overlong || surrogate || code > 0x10FFFF) return {};
  return {code, length, true};
}

bool isUtf8(std::string_view text) noexcept {
  while (!text.empty()) {
    if (static_cast<unsigned char>(text.front()) < 0x80) {
      text.remove_prefix(1);
      continue;
    }
    const Utf8Character character = firstCharacter(text);
    if (!character.valid) return false;
    text.remove_prefix(character.bytes);
  }
  return true;
}

bool isControl(char32_t code) noexcept {
  const bool steers = code < 0x20 || (code >= 0x7F && code <= 0x9F);
  const bool turns = code == 0x061C || code == 0x200E || code == 0x200F || (code >= 0x202A && code <= 0x202E) ||
                     (code >= 0x2066 && code <= 0x2069);
  return steers || turns || code == 0x2028 || code == 0x2029;
}

std::string_view trimmed(std::string_view text) noexcept {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::string replaced(std::string text, std::initializer_list<std::pair<std::string_view, std::string_view>> pairs) {
  for (const auto& [from, to] : pairs) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
      text.replace(at, from.size(), to);
  }
  return text;
}

std::string lowered(std::string_view text) {
  std::string out(text);
  for (char& c : out) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return out;
}

namespace {

// A longer word is a mistake of another kind; comparing it would cost the square of its length.
constexpr std::size_t kLongestWord = 100;
constexpr std::size_t kMostEdits = 3;

}  // namespace

std::size_t editDistance(std::string_view a, std::string_view b) {
  const std::string left = lowered(a);
  const std::string right = lowered(b);
  std::vector<std::size_t> before(right.size() + 1);
  std::vector<std::size_t> last(right.size() + 1);
  std::vector<std::size_t> now(right.size() + 1);
  for (std::size_t k = 0; k <= right.size(); ++k) last[k] = k;
  for (std::size_t i = 1; i <= left.size(); ++i) {
    now[0] = i;
    for (std::size_t k = 1; k <= right.size(); ++k) {
      const std::size_t replaced = last[k - 1] + (left[i - 1] == right[k - 1] ? 0 : 1);
      now[k] = std::min({last[k] + 1, now[k - 1] + 1, replaced});
      const bool swapped = i > 1 && k > 1 && left[i - 1] == right[k - 2] && left[i - 2] == right[k - 1];
      if (swapped) now[k] = std::min(now[k], before[k - 2] + 1);
    }
    std::swap(before, last);
    std::swap(last, now);
  }
  return last.back();
}

std::string closestWord(std::string_view word, std::span<const std::string> known) {
  if (word.empty() || word.size() > kLongestWord) return {};
  std::string best;
  std::size_t least = kMostEdits + 1;
  for (const auto& candidate : known) {
    if (candidate.size() > kLongestWord) continue;
    const std::size_t edits = editDistance(word, candidate);
    if (edits >= least || 3 * edits > std::max({candidate.size(), word.size(), std::size_t{3}})) continue;
    least = edits;
    best = candidate;
  }
  return best;
}

std::string suggestion(std::string_view word, std::span<const std::string> known) {
  const std::string close = closestWord(word, known);
  return close.empty() ? std::string() : " (" + close + "?)";
}

}  // namespace tactus::base
