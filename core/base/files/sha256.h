// SHA-256 of a text: says whether two texts are the same byte for byte.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace tactus::base {

/// SHA-256 (FIPS 180-4) of `bytes`, 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);

/// The same of bytes that come piece by piece.
class Sha256 {
 public:
  Sha256();
  void add(std::string_view bytes);
  /// Of everything that was added so far.
  std::string text() const;

 private:
  std::array<std::uint32_t, 8> state_;
  std::string waiting_;  ///< less than a block
  std::uint64_t bits_ = 0;
};

}  // namespace tactus::base
