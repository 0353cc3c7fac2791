#include "core/base/files/crc32.h"

#include <array>

namespace tactus::base {
namespace {

/// Table 0 takes one byte; table k takes a byte that k zero bytes follow, so that eight bytes are taken at once
/// (Kounavis and Berry 2008, "Novel Table Lookup-Based Algorithms for High-Performance CRC Generation", slicing-by-8).
using Tables = std::array<std::array<std::uint32_t, 256>, 8>;

constexpr Tables makeTables() {
  Tables tables{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t rest = byte;
    for (int bit = 0; bit < 8; ++bit) rest = (rest & 1U) != 0 ? 0xEDB88320U ^ (rest >> 1U) : rest >> 1U;
    tables[0][byte] = rest;
  }
  for (std::size_t k = 1; k < tables.size(); ++k) {
    for (std::size_t byte = 0; byte < 256; ++byte) {
      const std::uint32_t before = tables[k - 1][byte];
      tables[k][byte] = tables[0][before & 0xFFU] ^ (before >> 8U);
    }
  }
  return tables;
}

constexpr Tables kTables = makeTables();

}  // namespace

Crc32& Crc32::add(std::string_view bytes) noexcept {
  std::uint32_t rest = rest_;
  const auto at = [&](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i])); };
  while (bytes.size() >= 8) {
    const std::uint32_t low = rest ^ (at(0) | at(1) << 8U | at(2) << 16U | at(3) << 24U);
    rest = kTables[7][low & 0xFFU] ^ kTables[6][(low >> 8U) & 0xFFU] ^ kTables[5][(low >> 16U) & 0xFFU] ^
           kTables[4][low >> 24U] ^ kTables[3][at(4)] ^ kTables[2][at(5)] ^ kTables[1][at(6)] ^ kTables[0][at(7)];
    bytes.remove_prefix(8);
  }
  for (const char c : bytes) rest = kTables[0][(rest ^ static_cast<unsigned char>(c)) & 0xFFU] ^ (rest >> 8U);
  rest_ = rest;
  return *this;
}

std::uint32_t crc32(std::string_view bytes) noexcept { return Crc32().add(bytes).value(); }

}  // namespace tactus::base
