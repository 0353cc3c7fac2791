#include "core/base/files/checksums.h"

#include <array>
#include <bit>
#include <cstddef>

namespace tactus::base {
namespace {

using Word = std::uint32_t;
constexpr std::size_t kBlockBytes = 64;

/// FIPS 180-4, 4.2.2: the first 32 bits of the fractions of the cube roots of the first 64 primes.
constexpr std::array<Word, 64> kRound = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

/// FIPS 180-4, 5.3.3: the first 32 bits of the fractions of the square roots of the first 8 primes.
constexpr std::array<Word, 8> kStart = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                        0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};

/// FIPS 180-4, 6.2.2: one block into the state.
void take(std::array<Word, 8>& state, std::string_view block) {
  std::array<Word, 64> schedule{};
  for (std::size_t t = 0; t < 16; ++t) {
    for (std::size_t i = 0; i < 4; ++i)
      schedule[t] = (schedule[t] << 8U) | static_cast<unsigned char>(block[4 * t + i]);
  }
  for (std::size_t t = 16; t < 64; ++t) {
    const Word early = schedule[t - 15];
    const Word late = schedule[t - 2];
    schedule[t] = (std::rotr(late, 17) ^ std::rotr(late, 19) ^ (late >> 10U)) + schedule[t - 7] +
                  (std::rotr(early, 7) ^ std::rotr(early, 18) ^ (early >> 3U)) + schedule[t - 16];
  }

  auto [a, b, c, d, e, f, g, h] = state;
  for (std::size_t t = 0; t < 64; ++t) {
    const Word choice = (e & f) ^ (~e & g);
    const Word majority = (a & b) ^ (a & c) ^ (b & c);
    const Word first = h + (std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25)) + choice + kRound[t] + schedule[t];
    const Word second = (std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22)) + majority;
    h = g;
    g = f;
    f = e;
    e = d + first;
    d = c;
    c = b;
    b = a;
    a = first + second;
  }
  const std::array<Word, 8> change = {a, b, c, d, e, f, g, h};
  for (std::size_t i = 0; i < state.size(); ++i) state[i] += change[i];
}

}  // namespace

Sha256::Sha256() : state_(kStart) {}

void Sha256::add(std::string_view bytes) {
  bits_ += static_cast<std::uint64_t>(bytes.size()) * 8;
  if (!waiting_.empty()) {
    const auto missing = bytes.substr(0, kBlockBytes - waiting_.size());
    waiting_ += missing;
    bytes.remove_prefix(missing.size());
    if (waiting_.size() < kBlockBytes) return;
    take(state_, waiting_);
    waiting_.clear();
  }
  while (bytes.size() >= kBlockBytes) {
    take(state_, bytes.substr(0, kBlockBytes));
    bytes.remove_prefix(kBlockBytes);
  }
  waiting_ = bytes;
}

std::string Sha256::text() const {
  // FIPS 180-4, 5.1.1: a one bit, zeros, and the length in bits.
  std::array<Word, 8> state = state_;
  std::string last = waiting_;
  last += static_cast<char>(0x80);
  while (last.size() % kBlockBytes != kBlockBytes - 8) last += '\0';
  for (int shift = 56; shift >= 0; shift -= 8)
    last += static_cast<char>((bits_ >> static_cast<unsigned>(shift)) & 0xFFU);
  for (std::size_t at = 0; at < last.size(); at += kBlockBytes)
    take(state, std::string_view(last).substr(at, kBlockBytes));

  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  for (const Word word : state) {
    for (int shift = 28; shift >= 0; shift -= 4) text += kDigits[(word >> static_cast<unsigned>(shift)) & 0xFU];
  }
  return text;
}

std::string sha256(std::string_view bytes) {
  Sha256 hash;
  hash.add(bytes);
  return hash.text();
}

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
