// Checksums: CRC-32 against accidental change, SHA-256 to compare byte for byte.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace tactus::base {

// SHA-256 of a text, to compare texts byte for byte.

/// SHA-256 (FIPS 180-4) of `bytes`, 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);

/// The same for bytes that arrive in pieces.
class Sha256 {
 public:
  Sha256();
  void add(std::string_view bytes);
  /// SHA-256 of all bytes added so far.
  std::string text() const;

 private:
  std::array<std::uint32_t, 8> state_;
  std::string waiting_;  ///< less than one block
  std::uint64_t bits_ = 0;
};

// Checksum of a block of bytes against accidental change.

/// CRC-32 as in Ethernet, zip and PNG (polynomial 0xEDB88320 reflected, start and final inversion 0xFFFFFFFF).
std::uint32_t crc32(std::string_view bytes) noexcept;

/// The same for bytes that arrive in pieces.
class Crc32 {
 public:
  Crc32& add(std::string_view bytes) noexcept;
  /// CRC of all bytes added so far.
  std::uint32_t value() const noexcept { return ~rest_; }

 private:
  std::uint32_t rest_ = 0xFFFFFFFFU;
};

}  // namespace tactus::base
