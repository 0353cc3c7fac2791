// SHA-256 of a text, to compare texts byte for byte.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace tactus::base {

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

}  // namespace tactus::base
