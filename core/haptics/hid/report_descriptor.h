// The structure of a HID device's reports, read from its report descriptor (USB HID 1.11, section 6.2.2).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/error.h"

namespace tactus::haptics {

enum class ReportType : std::uint8_t { kInput, kOutput, kFeature };

/// The meaning of a value: a page of the usage tables and a number on it.
struct Usage {
  std::uint16_t page = 0;
  std::uint16_t id = 0;

  bool operator==(const Usage&) const = default;
};

/// One main item with data: `count` values of `bit_size` bits, one after the other.
struct HidField {
  struct UsageRange {
    Usage first;
    std::uint16_t last = 0;  ///< on the page of `first`; not less than it
  };

  ReportType type = ReportType::kInput;
  std::uint8_t report_id = 0;    ///< 0: the device does not number its reports
  std::uint32_t bit_offset = 0;  ///< of the first value; bit 0 is the lowest bit of the byte after the id
  std::uint32_t bit_size = 0;    ///< of one value
  std::uint32_t count = 0;
  bool constant = false;  ///< padding
  bool variable = false;  ///< one value per usage; otherwise an array, in which the value selects the usage
  std::int64_t logical_min = 0;
  std::int64_t logical_max = 0;
  std::int64_t physical_min = 0;
  std::int64_t physical_max = 0;
  int unit_exponent = 0;   ///< power of ten
  std::uint32_t unit = 0;  ///< as in the descriptor
  std::vector<UsageRange> usages;
  std::vector<Usage> path;  ///< usages of the enclosing collections, outermost first

  bool isInside(Usage collection) const;
  /// Index of `usage` in the list of usages, or nothing.
  std::optional<std::uint32_t> indexOf(Usage usage) const;
  /// The usage of value `index` of a variable field. The last usage applies to all following values. Nothing without
  /// usages.
  std::optional<Usage> usageAt(std::uint32_t index) const;
  /// Number of usages in the list.
  std::uint64_t usageCount() const;
};

/// All reports of one device. Reports of different types may share an id, so offsets count per type and id.
class ReportDescriptor {
 public:
  static constexpr std::size_t kMostBytes = 4096;  ///< as in the Linux kernel
  static constexpr std::size_t kDeepest = 32;      ///< nested collections, and nested pushed states

  /// Parses a descriptor. Returns an error for: truncated items, unmatched collections, a pop without a push, reserved
  /// items, reports longer than 8192 bytes, a logical range with min > max of values that are not padding. The place in
  /// the error is the byte of the item.
  static base::Result<ReportDescriptor> parse(std::span<const std::uint8_t> bytes);

  const std::vector<HidField>& fields() const { return fields_; }
  /// Whether byte 0 of each report is its id. hidapi expects that byte (as 0) in either case.
  bool numbered() const { return numbered_; }
  /// Length of a report including its id byte; 0 if there is no such report.
  std::size_t reportBytes(ReportType type, std::uint8_t id) const;

 private:
  friend class DescriptorReader;

  struct ReportSize {
    ReportType type;
    std::uint8_t id;
    std::uint32_t bits;
  };

  std::vector<HidField> fields_;
  std::vector<ReportSize> sizes_;
  bool numbered_ = false;
};

}  // namespace tactus::haptics
