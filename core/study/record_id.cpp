#include "core/study/record_id.h"

namespace tactus::study {
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
