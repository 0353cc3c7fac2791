#include "core/study/record_id.h"

#include <array>
#include <cctype>

#include "core/base/text.h"

namespace tactus::study {
namespace {

/// Spaces and dashes that look like the ASCII ones: no-break space, soft hyphen, zero-width space and joiners,
/// en space to hair space, hyphens and dashes, narrow no-break space, minus, ideographic space, byte order mark.
bool isDashOrSpace(char32_t code) {
  return code == 0xA0 || code == 0xAD || (code >= 0x2000 && code <= 0x2015) || code == 0x202F || code == 0x2212 ||
         code == 0x3000 || code == 0xFEFF;
}

/// The character that begins at text[at], and its length in bytes; well-formed UTF-8.
std::pair<char32_t, std::size_t> characterAt(std::string_view text, std::size_t at) {
  const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(at);
  const std::size_t size = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  if (size == 1 || at + size > text.size()) return {first, 1};
  constexpr std::array<unsigned, 5> kMask = {0, 0x7F, 0x1F, 0x0F, 0x07};
  char32_t code = first & kMask[size];
  for (std::size_t i = 1; i < size; ++i) code = (code << 6U) | (byte(at + i) & 0x3FU);
  return {code, size};
}

}  // namespace

std::string codeKey(std::string_view code) {
  std::string key;
  for (std::size_t at = 0; at < code.size();) {
    auto [character, size] = characterAt(code, at);
    const std::string_view bytes = code.substr(at, size);
    at += size;
    if (character >= 0xFF01 && character <= 0xFF5E) character -= 0xFEE0;  // full-width forms of ASCII
    if (character >= 0x80) {
      if (!isDashOrSpace(character)) key += bytes;
      continue;
    }
    const auto ascii = static_cast<unsigned char>(character);
    if (std::isalnum(ascii) == 0) continue;
    const bool after_digit = !key.empty() && base::isDigit(key.back());
    // A zero before the rest of a number goes; it comes back where it was the whole number.
    if (after_digit && key.back() == '0' && std::isdigit(ascii) != 0 &&
        (key.size() == 1 || !base::isDigit(key[key.size() - 2]))) {
      key.pop_back();
    }
    key += static_cast<char>(std::tolower(ascii));
  }
  return key;
}

namespace {

std::mt19937_64 engineFromEntropy() {
  std::random_device device;
  std::seed_seq words{device(), device(), device(), device(), device(), device(), device(), device()};
  return std::mt19937_64(words);
}

int digitValue(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

std::string toText(const RecordId& id) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  text.reserve(2 * id.bytes.size());
  for (const std::uint8_t byte : id.bytes) {
    text += kDigits[byte >> 4U];
    text += kDigits[byte & 0xFU];
  }
  return text;
}

std::optional<RecordId> parseRecordId(std::string_view text) {
  RecordId id;
  if (text.size() != 2 * id.bytes.size()) return std::nullopt;
  for (std::size_t i = 0; i < id.bytes.size(); ++i) {
    const int high = digitValue(text[2 * i]);
    const int low = digitValue(text[2 * i + 1]);
    if (high < 0 || low < 0) return std::nullopt;
    id.bytes[i] = static_cast<std::uint8_t>(high * 16 + low);
  }
  return id;
}

RecordIds::RecordIds() : engine_(engineFromEntropy()) {}

RecordId RecordIds::next() {
  RecordId id;
  for (std::size_t half = 0; half < 2; ++half) {
    const std::uint64_t word = engine_();
    for (std::size_t i = 0; i < 8; ++i) id.bytes[8 * half + i] = static_cast<std::uint8_t>(word >> (8 * i));
  }
  return id;
}

}  // namespace tactus::study
