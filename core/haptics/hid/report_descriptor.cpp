#include "core/haptics/hid/report_descriptor.h"

#include <algorithm>
#include <string>

namespace tactus::haptics {
namespace {

constexpr std::uint32_t kMostValueBits = 256;
constexpr std::uint32_t kMostValues = 12288;
constexpr std::uint32_t kMostReportBits = 8192 * 8;

/// Type and tag of an item, its size code masked out (USB HID 1.11, 6.2.2.4 to 6.2.2.8).
enum Item : std::uint8_t {
  kInputItem = 0x80,
  kOutputItem = 0x90,
  kFeatureItem = 0xB0,
  kCollection = 0xA0,
  kEndCollection = 0xC0,
  kUsagePage = 0x04,
  kLogicalMin = 0x14,
  kLogicalMax = 0x24,
  kPhysicalMin = 0x34,
  kPhysicalMax = 0x44,
  kUnitExponent = 0x54,
  kUnit = 0x64,
  kReportSize = 0x74,
  kReportId = 0x84,
  kReportCount = 0x94,
  kPush = 0xA4,
  kPop = 0xB4,
  kUsage = 0x08,
  kUsageMin = 0x18,
  kUsageMax = 0x28,
  kDelimiter = 0xA8,
};
constexpr std::uint8_t kLongItem = 0xFE;
constexpr int kGlobalType = 1;
constexpr int kReservedType = 3;

/// The data of an item. Whether a limit is signed is known only when both ends are there.
struct Data {
  std::uint32_t bits = 0;
  int bytes = 0;

  std::int64_t asSigned() const {
    if (bytes == 1) return static_cast<std::int8_t>(bits);
    if (bytes == 2) return static_cast<std::int16_t>(bits);
    return static_cast<std::int32_t>(bits);
  }
};

struct Range {
  Data min;
  Data max;

  std::int64_t low() const { return min.asSigned(); }
  /// Signed only beside a negative minimum: firmwares write 255 as one byte FF.
  std::int64_t high() const { return low() < 0 ? max.asSigned() : static_cast<std::int64_t>(max.bits); }
};

struct Globals {
  std::uint16_t page = 0;
  Range logical;
  Range physical;
  int exponent = 0;
  std::uint32_t unit = 0;
  std::uint32_t size = 0;
  std::uint32_t count = 0;
  std::uint8_t id = 0;
};

struct LongUsage {
  Data data;

  /// A usage of four bytes carries its page; a shorter one takes the page in force at the main item.
  Usage on(std::uint16_t page) const {
    if (data.bytes == 4) return {static_cast<std::uint16_t>(data.bits >> 16U), static_cast<std::uint16_t>(data.bits)};
    return {page, static_cast<std::uint16_t>(data.bits)};
  }
};

struct Locals {
  struct Entry {
    LongUsage first;
    LongUsage last;
  };

  std::vector<Entry> usages;
  std::optional<LongUsage> min;
  bool in_set = false;      ///< between delimiters: alternatives of one usage
  bool set_filled = false;  ///< only the first, preferred one counts
};

std::string hex(unsigned value) {
  constexpr char kDigits[] = "0123456789abcdef";
  return {'0', 'x', kDigits[value >> 4U & 0xFU], kDigits[value & 0xFU]};
}

}  // namespace

bool HidField::isInside(Usage collection) const {
  return std::find(path.begin(), path.end(), collection) != path.end();
}

std::optional<std::uint32_t> HidField::indexOf(Usage usage) const {
  std::uint32_t index = 0;
  for (const UsageRange& range : usages) {
    if (range.first.page == usage.page && usage.id >= range.first.id && usage.id <= range.last)
      return index + (usage.id - range.first.id);
    index += static_cast<std::uint32_t>(range.last - range.first.id) + 1;
  }
  return std::nullopt;
}

std::optional<Usage> HidField::usageAt(std::uint32_t index) const {
  for (const UsageRange& range : usages) {
    const std::uint32_t length = static_cast<std::uint32_t>(range.last - range.first.id) + 1;
    if (index < length) return Usage{range.first.page, static_cast<std::uint16_t>(range.first.id + index)};
    index -= length;
  }
  if (usages.empty()) return std::nullopt;
  return Usage{usages.back().first.page, usages.back().last};
}

std::uint64_t HidField::usageCount() const {
  std::uint64_t count_of_all = 0;
  for (const UsageRange& range : usages) count_of_all += static_cast<std::uint64_t>(range.last - range.first.id) + 1;
  return count_of_all;
}

std::size_t ReportDescriptor::reportBytes(ReportType type, std::uint8_t id) const {
  for (const ReportSize& size : sizes_) {
    if (size.type == type && size.id == id) return 1 + (size.bits + 7) / 8;
  }
  return 0;
}

/// Walks over the items once.
class DescriptorReader {
 public:
  explicit DescriptorReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  base::Result<ReportDescriptor> read() {
    if (bytes_.empty()) return refuse("nothing", "at least one item");
    if (bytes_.size() > ReportDescriptor::kMostBytes)
      return refuse(std::to_string(bytes_.size()) + " bytes",
                    "at most " + std::to_string(ReportDescriptor::kMostBytes) + " bytes");
    while (next_ < bytes_.size()) {
      at_ = next_;
      if (auto done = readItem(); !done) return tl::unexpected(done.error());
    }
    at_ = bytes_.size();
    if (!path_.empty())
      return refuse(std::to_string(path_.size()) + " open collections at the end", "all of them closed");
    return std::move(out_);
  }

 private:
  using Done = base::Result<void>;

  tl::unexpected<base::Error> refuse(std::string found, std::string wanted) const {
    return base::fail(base::ErrorCode::kSyntax, "report descriptor, byte " + std::to_string(at_), std::move(found),
                      std::move(wanted));
  }

  Done readItem() {
    const std::uint8_t prefix = bytes_[next_++];
    const std::size_t left = bytes_.size() - next_;
    if (prefix == kLongItem) {
      // Size, tag, data: reserved for vendors, without meaning here.
      if (left < 2 || left - 2 < bytes_[next_]) return refuse("a long item that is cut off", "all its bytes");
      next_ += 2 + static_cast<std::size_t>(bytes_[next_]);
      return {};
    }
    const int code = prefix & 3;
    Data data{0, code == 3 ? 4 : code};
    if (left < static_cast<std::size_t>(data.bytes))
      return refuse("item " + hex(prefix) + " that is cut off", "all its bytes");
    for (int i = 0; i < data.bytes; ++i) data.bits |= static_cast<std::uint32_t>(bytes_[next_++]) << (8 * i);
    const int type = prefix >> 2 & 3;
    if (type == kReservedType)
      return refuse("item " + hex(prefix) + " of the reserved type", "a main, global or local item");
    const auto item = static_cast<std::uint8_t>(prefix & 0xFC);
    if (type == kGlobalType) return readGlobal(item, data);
    return type == 0 ? readMain(item, data) : readLocal(item, data);
  }

  Done readGlobal(std::uint8_t item, const Data& data) {
    switch (item) {
      case kUsagePage: globals_.page = static_cast<std::uint16_t>(data.bits); return {};
      case kLogicalMin: globals_.logical.min = data; return {};
      case kLogicalMax: globals_.logical.max = data; return {};
      case kPhysicalMin: globals_.physical.min = data; return {};
      case kPhysicalMax: globals_.physical.max = data; return {};
      case kUnitExponent: {
        const int nibble = static_cast<int>(data.bits & 0xFU);
        globals_.exponent = nibble < 8 ? nibble : nibble - 16;
        return {};
      }
      case kUnit: globals_.unit = data.bits; return {};
      case kReportSize:
        if (data.bits > kMostValueBits)
          return refuse("values of " + std::to_string(data.bits) + " bits", "at most 256 bits");
        globals_.size = data.bits;
        return {};
      case kReportCount:
        if (data.bits > kMostValues) return refuse(std::to_string(data.bits) + " values in one item", "at most 12288");
        globals_.count = data.bits;
        return {};
      case kReportId:
        if (data.bits == 0 || data.bits > 255) return refuse("report id " + std::to_string(data.bits), "1 to 255");
        globals_.id = static_cast<std::uint8_t>(data.bits);
        out_.numbered_ = true;
        return {};
      case kPush:
        if (pushed_.size() == ReportDescriptor::kDeepest) return refuse("more than 32 pushed states", "fewer");
        pushed_.push_back(globals_);
        return {};
      case kPop:
        if (pushed_.empty()) return refuse("a pop", "a push before it");
        globals_ = pushed_.back();
        pushed_.pop_back();
        return {};
      default: return refuse("global item " + hex(item), "an item of HID 1.11");
    }
  }

  Done readLocal(std::uint8_t item, const Data& data) {
    if (item == kDelimiter) {
      locals_.in_set = data.bits == 1;
      locals_.set_filled = false;
      return {};
    }
    if (item == kUsageMin) {
      locals_.min = LongUsage{data};
      return {};
    }
    // Designators and strings say nothing that is needed here.
    if (item != kUsage && item != kUsageMax) return {};
    if (locals_.in_set && locals_.set_filled) return {};
    locals_.set_filled = true;
    if (item == kUsage) {
      locals_.usages.push_back({LongUsage{data}, LongUsage{data}});
      return {};
    }
    if (!locals_.min) return refuse("a usage maximum", "a usage minimum before it");
    const LongUsage min = *locals_.min;
    locals_.min.reset();
    if (min.on(0).id > LongUsage{data}.on(0).id)
      return refuse("a usage maximum below the usage minimum", "minimum first");
    locals_.usages.push_back({min, LongUsage{data}});
    return {};
  }

  Done readMain(std::uint8_t item, const Data& data) {
    Done done;
    if (item == kCollection) {
      done = openCollection();
    } else if (item == kEndCollection) {
      if (path_.empty()) return refuse("the end of a collection", "its beginning before it");
      path_.pop_back();
    } else if (item == kInputItem) {
      done = addField(ReportType::kInput, data.bits);
    } else if (item == kOutputItem) {
      done = addField(ReportType::kOutput, data.bits);
    } else if (item == kFeatureItem) {
      done = addField(ReportType::kFeature, data.bits);
    }
    locals_ = {};
    return done;
  }

  Done openCollection() {
    if (path_.size() == ReportDescriptor::kDeepest)
      return refuse("more than 32 collections inside each other", "fewer");
    path_.push_back(locals_.usages.empty() ? Usage{} : locals_.usages.front().first.on(globals_.page));
    return {};
  }

  Done addField(ReportType type, std::uint32_t flags) {
    if (globals_.count == 0 || globals_.size == 0) return {};
    auto report = std::find_if(out_.sizes_.begin(), out_.sizes_.end(),
                               [&](const auto& size) { return size.type == type && size.id == globals_.id; });
    if (report == out_.sizes_.end()) report = out_.sizes_.insert(report, {type, globals_.id, 0});
    HidField field;
    field.bit_offset = report->bits;
    report->bits += globals_.size * globals_.count;  // at most 256 * 12288, so never around
    if (report->bits > kMostReportBits)
      return refuse("report " + std::to_string(globals_.id) + " of " + std::to_string(report->bits) + " bits",
                    "at most 8192 bytes");
    field.type = type;
    field.report_id = globals_.id;
    field.bit_size = globals_.size;
    field.count = globals_.count;
    field.constant = (flags & 1U) != 0;
    field.variable = (flags & 2U) != 0;
    field.logical_min = globals_.logical.low();
    field.logical_max = globals_.logical.high();
    field.physical_min = globals_.physical.low();
    field.physical_max = globals_.physical.high();
    if (!field.constant && field.logical_min > field.logical_max)
      return refuse(
          "a logical range from " + std::to_string(field.logical_min) + " to " + std::to_string(field.logical_max),
          "minimum first");
    field.unit_exponent = globals_.exponent;
    field.unit = globals_.unit;
    field.path = path_;
    for (const auto& entry : locals_.usages) {
      const Usage first = entry.first.on(globals_.page);
      field.usages.push_back({first, entry.last.on(first.page).id});
    }
    out_.fields_.push_back(std::move(field));
    return {};
  }

  std::span<const std::uint8_t> bytes_;
  std::size_t next_ = 0;
  std::size_t at_ = 0;
  Globals globals_;
  Locals locals_;
  std::vector<Globals> pushed_;
  std::vector<Usage> path_;
  ReportDescriptor out_;
};

base::Result<ReportDescriptor> ReportDescriptor::parse(std::span<const std::uint8_t> bytes) {
  return DescriptorReader(bytes).read();
}

}  // namespace tactus::haptics
