// The state of an insertion as bytes: one function names the members, the writer or the reader goes through them.
// Example of such a function: take.number(state.depth_mm, -1e9, 1e9); take.whole(state.phase, 3);
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <type_traits>

namespace tactus::render {

/// Writes each member as 8 bytes of this machine. Members beyond the end of the bytes are counted and not written, so a
/// writer without bytes counts. Real-time safe: yes.
class StateWriter {
 public:
  explicit StateWriter(std::span<std::byte> bytes = {}) noexcept : bytes_(bytes) {}

  void number(double value, double /*min*/, double /*max*/) noexcept { put(std::bit_cast<std::uint64_t>(value)); }
  template <typename Whole>
  void whole(Whole value, std::uint64_t /*most*/ = ~std::uint64_t{0}) noexcept {
    put(static_cast<std::uint64_t>(value));
  }
  /// Of all members so far.
  std::size_t size() const noexcept { return size_; }

 private:
  void put(std::uint64_t bits) noexcept {
    if (size_ + sizeof bits <= bytes_.size()) std::memcpy(bytes_.data() + size_, &bits, sizeof bits);
    size_ += sizeof bits;
  }

  std::span<std::byte> bytes_;
  std::size_t size_ = 0;
};

/// Reads what a StateWriter wrote. A value out of its range, NaN, or an end too early makes `fits` false; what was read
/// is then not to be used. Real-time safe: yes.
class StateReader {
 public:
  explicit StateReader(std::span<const std::byte> bytes) noexcept : bytes_(bytes) {}

  void number(double& value, double min, double max) noexcept {
    value = std::bit_cast<double>(get());
    fits_ = fits_ && value >= min && value <= max;
  }
  template <typename Whole>
  void whole(Whole& value, std::uint64_t most = ~std::uint64_t{0}) noexcept {
    const std::uint64_t bits = get();
    fits_ = fits_ && bits <= most;
    value = static_cast<Whole>(fits_ ? bits : 0);
  }
  bool fits() const noexcept { return fits_; }
  /// The bytes that were not read yet.
  std::span<const std::byte> rest() const noexcept { return bytes_; }

 private:
  std::uint64_t get() noexcept {
    std::uint64_t bits = 0;
    fits_ = fits_ && bytes_.size() >= sizeof bits;
    if (!fits_) return 0;
    std::memcpy(&bits, bytes_.data(), sizeof bits);
    bytes_ = bytes_.subspan(sizeof bits);
    return bits;
  }

  std::span<const std::byte> bytes_;
  bool fits_ = true;
};

/// Whether `value` is there, and what `members` names of it (of a default one where it is not).
template <typename Optional, typename Take, typename Members>
void takeOptional(Optional& value, Take& take, Members&& members) noexcept {
  bool there = value.has_value();
  take.whole(there, 1);
  auto inside = value.value_or(typename std::remove_const_t<Optional>::value_type{});
  members(inside);
  if constexpr (!std::is_const_v<Optional>) {
    value.reset();
    if (there) value = inside;
  }
}

}  // namespace tactus::render
