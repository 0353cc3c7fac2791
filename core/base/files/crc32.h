// Checksum of a block of bytes against accidental change.
#pragma once

#include <cstdint>
#include <string_view>

namespace tactus::base {

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
