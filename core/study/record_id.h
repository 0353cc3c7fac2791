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

/// A random 128-bit id, so that the records of several stations can be put into one file.
struct RecordId {
  std::array<std::uint8_t, 16> bytes{};

  /// All zero: names nothing.
  bool isNil() const noexcept { return *this == RecordId{}; }
  auto operator<=>(const RecordId&) const = default;
};

/// 32 lower-case hexadecimal digits.
std::string toText(const RecordId& id);

/// The id written as 32 hexadecimal digits, or nothing.
std::optional<RecordId> parseRecordId(std::string_view text);

/// Makes ids that were never used before.
class RecordIds {
 public:
  /// Seeded by the operating system.
  RecordIds();
  /// The same ids for the same seed: for simulated studies and tests only.
  explicit RecordIds(std::uint64_t seed) : engine_(seed) {}

  RecordId next();

 private:
  std::mt19937_64 engine_;
};

}  // namespace tactus::study
