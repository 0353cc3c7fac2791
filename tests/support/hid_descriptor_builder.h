// Writes HID report descriptors item by item, for devices that exist only in tests.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <utility>
#include <vector>

namespace tactus::support {

/// Each call appends one item in its shortest size; the names are those of the HID specification (6.2.2).
class HidDescriptorBuilder {
 public:
  static constexpr int kConstant = 0x01;
  static constexpr int kVariable = 0x02;
  static constexpr int kArray = 0x00;

  HidDescriptorBuilder& page(std::uint32_t value) { return unsignedItem(0x04, value); }
  HidDescriptorBuilder& logical(std::int64_t low, std::int64_t high) {
    signedItem(0x14, low);
    return low < 0 ? signedItem(0x24, high) : unsignedItem(0x24, static_cast<std::uint32_t>(high));
  }
  HidDescriptorBuilder& physical(std::int64_t low, std::int64_t high) {
    signedItem(0x34, low);
    return low < 0 ? signedItem(0x44, high) : unsignedItem(0x44, static_cast<std::uint32_t>(high));
  }
  HidDescriptorBuilder& exponent(int value) { return unsignedItem(0x54, static_cast<std::uint32_t>(value) & 0x0F); }
  HidDescriptorBuilder& unit(std::uint32_t value) { return unsignedItem(0x64, value); }
  HidDescriptorBuilder& size(std::uint32_t bits) { return unsignedItem(0x74, bits); }
  HidDescriptorBuilder& id(std::uint32_t value) { return unsignedItem(0x84, value); }
  HidDescriptorBuilder& count(std::uint32_t value) { return unsignedItem(0x94, value); }
  HidDescriptorBuilder& push() { return bare(0xA4); }
  HidDescriptorBuilder& pop() { return bare(0xB4); }
  HidDescriptorBuilder& usage(std::uint32_t value) { return unsignedItem(0x08, value); }
  HidDescriptorBuilder& usages(std::initializer_list<std::uint32_t> values) {
    for (const auto value : values) usage(value);
    return *this;
  }
  HidDescriptorBuilder& usageRange(std::uint32_t first, std::uint32_t last) {
    return unsignedItem(0x18, first).unsignedItem(0x28, last);
  }
  /// A usage with its page in one item of four bytes.
  HidDescriptorBuilder& longUsage(std::uint16_t of_page, std::uint16_t value) {
    return sized(0x08, static_cast<std::uint32_t>(of_page) << 16U | value, 4);
  }
  HidDescriptorBuilder& input(int flags) { return sized(0x80, static_cast<std::uint32_t>(flags), 1); }
  HidDescriptorBuilder& output(int flags) { return sized(0x90, static_cast<std::uint32_t>(flags), 1); }
  HidDescriptorBuilder& feature(int flags) { return sized(0xB0, static_cast<std::uint32_t>(flags), 1); }
  HidDescriptorBuilder& application() { return sized(0xA0, 1, 1); }
  HidDescriptorBuilder& collection() { return sized(0xA0, 2, 1); }  ///< logical
  HidDescriptorBuilder& end() { return bare(0xC0); }

  /// Any item: `prefix` without its size code, then `value` in `bytes` (0, 1, 2 or 4) little-endian bytes.
  HidDescriptorBuilder& sized(std::uint8_t prefix, std::uint32_t value, int bytes) {
    bytes_.push_back(static_cast<std::uint8_t>(prefix | (bytes == 4 ? 3 : bytes)));
    for (int i = 0; i < bytes; ++i) bytes_.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
    return *this;
  }
  HidDescriptorBuilder& raw(std::initializer_list<int> values) {
    for (const int value : values) bytes_.push_back(static_cast<std::uint8_t>(value));
    return *this;
  }

  std::vector<std::uint8_t> take() { return std::move(bytes_); }

 private:
  HidDescriptorBuilder& bare(std::uint8_t prefix) { return sized(prefix, 0, 0); }
  HidDescriptorBuilder& unsignedItem(std::uint8_t prefix, std::uint32_t value) {
    return sized(prefix, value, value <= 0xFF ? 1 : value <= 0xFFFF ? 2 : 4);
  }
  HidDescriptorBuilder& signedItem(std::uint8_t prefix, std::int64_t value) {
    const int bytes = value >= -128 && value <= 127 ? 1 : value >= -32768 && value <= 32767 ? 2 : 4;
    return sized(prefix, static_cast<std::uint32_t>(value), bytes);
  }

  std::vector<std::uint8_t> bytes_;
};

}  // namespace tactus::support
