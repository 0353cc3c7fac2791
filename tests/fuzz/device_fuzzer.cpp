#include "tests/fuzz/device_fuzzer.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/check.h"
#include "core/haptics/hid/hid_pid_device.h"
#include "core/haptics/hid/pid_layout.h"
#include "core/haptics/hid/report_descriptor.h"

namespace tactus::fuzz {
namespace {

using Bytes = std::span<const std::uint8_t>;

/// Each end of the range of `slot`, put into `report` and taken out again.
void keepsItsEnds(const haptics::PidReport& report, const haptics::ValueSlot& slot) {
  for (const std::int64_t value : {slot.logical_min, slot.logical_max}) {
    std::vector<std::uint8_t> bytes = report.blank();
    haptics::putValue(bytes, slot, value);
    TACTUS_CHECK(bytes.size() == report.bytes && bytes.front() == report.id);
    TACTUS_CHECK(haptics::takeValue(bytes, slot) == value);
  }
}

void keepsItsValues(const haptics::PidLayout& layout) {
  keepsItsEnds(layout.constant_force.report, layout.constant_force.magnitude);
  keepsItsEnds(layout.constant_force.report, layout.constant_force.block);
  keepsItsEnds(layout.set_effect.report, layout.set_effect.block);
  for (const haptics::ValueSlot& slot : layout.set_effect.directions) keepsItsEnds(layout.set_effect.report, slot);
  const haptics::ValueSlot& magnitude = layout.constant_force.magnitude;
  for (const double share : {-1.0, -0.5, 0.0, 0.5, 1.0, std::nan("")}) {
    const std::int64_t raw = haptics::rawOfShare(magnitude, share);
    TACTUS_CHECK(raw >= magnitude.logical_min && raw <= magnitude.logical_max);
  }
}

/// `bytes` cut into input reports of the lengths that `descriptor` gives to the first bytes of each.
void takesReports(const haptics::ReportDescriptor& descriptor, const haptics::PidLayout& layout, Bytes bytes) {
  const std::int64_t blocks[] = {1, 2};
  haptics::PidInput input(layout, blocks);
  std::int64_t now_ns = 0;
  while (!bytes.empty()) {
    const std::uint8_t id = descriptor.numbered() ? bytes.front() : 0;
    const std::size_t known = descriptor.reportBytes(haptics::ReportType::kInput, id);
    const std::size_t size = std::clamp<std::size_t>(known, 1, bytes.size());
    now_ns += 1'000'000;
    (void)input.take(bytes.first(size), now_ns);
    (void)input.watchEffects(now_ns, now_ns / 2, now_ns / 3);
    for (const double counts : input.sample().counts) TACTUS_CHECK(std::isfinite(counts));
    bytes = bytes.subspan(size);
  }
}

}  // namespace

void fuzzHid(std::string_view bytes) {
  const Bytes raw(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  const auto descriptor = haptics::ReportDescriptor::parse(raw);
  if (!descriptor) return;
  for (const haptics::HidField& field : descriptor->fields()) {
    TACTUS_CHECK(field.constant || field.logical_min <= field.logical_max);
    (void)field.usageAt(0);
    (void)field.usageAt(field.count);
  }
  (void)haptics::claimsPid(*descriptor);
  const auto layout = haptics::PidLayout::find(*descriptor);
  if (!layout) {
    TACTUS_CHECK(!layout.error().wanted.empty());
    return;
  }
  keepsItsValues(*layout);
  takesReports(*descriptor, *layout, raw);
}

}  // namespace tactus::fuzz
