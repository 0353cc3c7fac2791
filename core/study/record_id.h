// Random 128-bit ids of the records of a study file.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <string_view>

namespace tactus::study {

// Comparison keys for participant codes.

/// The key of a code. Codes that a person reads as the same one have the same key. It keeps lower-case letters and
/// digits, and drops leading zeros of numbers. `S1`, `s-01` and ` S 1` all give `s1`. Characters beyond ASCII stay,
/// except Unicode dashes and spaces.
std::string codeKey(std::string_view code);

/// A random 128-bit id, so that the records of several stations can be merged into one file.
struct RecordId {
  std::array<std::uint8_t, 16> bytes{};

  /// Whether all bytes are zero: no record has this id.
  bool isNil() const noexcept { return *this == RecordId{}; }
  auto operator<=>(const RecordId&) const = default;
};

/// 32 lower-case hexadecimal digits.
std::string toText(const RecordId& id);

/// Parses 32 hexadecimal digits; nothing for any other text.
std::optional<RecordId> parseRecordId(std::string_view text);

/// Generates new ids, unique for all practical purposes.
class RecordIds {
 public:
  /// Seeded by the operating system.
  RecordIds();
  /// The same seed gives the same ids. For simulated studies and tests only.
  explicit RecordIds(std::uint64_t seed) : engine_(seed) {}

  RecordId next();

 private:
  std::mt19937_64 engine_;
};

}  // namespace tactus::study
