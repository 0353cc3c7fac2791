#include "core/haptics/hid/pid_layout.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/text.h"

namespace tactus::haptics {
namespace {

/// The exponents of a unit (USB HID 1.11, 6.2.2.7): time to the power of 1, and nothing else.
constexpr std::uint32_t kTime = 0x1000;

/// Seconds in any of the four systems of units.
bool isSeconds(std::uint32_t unit) noexcept {
  return (unit & ~0xFU) == kTime && (unit & 0xFU) >= 1 && (unit & 0xFU) <= 4;
}

std::int64_t rounded(double value, const ValueSlot& slot) noexcept {
  const auto low = static_cast<double>(slot.logical_min);
  const auto high = static_cast<double>(slot.logical_max);
  return static_cast<std::int64_t>(std::clamp(std::round(value), low, high));
}

}  // namespace

void putValue(std::span<std::uint8_t> report, const ValueSlot& slot, std::int64_t value) noexcept {
  const auto bits = static_cast<std::uint64_t>(value);
  for (std::uint32_t i = 0; i < slot.bit_size; ++i) {
    const std::size_t byte = 1 + (slot.bit_offset + i) / 8;
    if (byte >= report.size()) return;
    const auto mask = static_cast<std::uint8_t>(1U << ((slot.bit_offset + i) % 8));
    const bool set = (bits >> i & 1U) != 0;
    report[byte] = static_cast<std::uint8_t>(set ? report[byte] | mask : report[byte] & ~mask);
  }
}

std::int64_t takeValue(std::span<const std::uint8_t> report, const ValueSlot& slot) noexcept {
  std::uint64_t bits = 0;
  for (std::uint32_t i = 0; i < slot.bit_size; ++i) {
    const std::size_t byte = 1 + (slot.bit_offset + i) / 8;
    if (byte >= report.size()) break;
    if ((report[byte] >> ((slot.bit_offset + i) % 8) & 1U) != 0) bits |= std::uint64_t{1} << i;
  }
  if (slot.bit_size == 0 || slot.logical_min >= 0) return static_cast<std::int64_t>(bits);
  const std::uint64_t sign = std::uint64_t{1} << (slot.bit_size - 1);
  return static_cast<std::int64_t>(bits) - static_cast<std::int64_t>(2 * (bits & sign));
}

std::int64_t allOnes(const ValueSlot& slot) noexcept { return (std::int64_t{1} << slot.bit_size) - 1; }

std::int64_t rawOfShare(const ValueSlot& slot, double share) noexcept {
  if (std::isnan(share)) share = 0;
  share = std::clamp(share, -1.0, 1.0);
  const auto low = static_cast<double>(slot.logical_min);
  const auto high = static_cast<double>(slot.logical_max);
  if (slot.logical_min >= 0) return rounded(low + std::max(share, 0.0) * (high - low), slot);
  return rounded(share >= 0 ? share * high : -share * low, slot);
}

bool rangeFits(const ValueSlot& slot) noexcept {
  const bool with_sign = slot.logical_min < 0;
  const std::int64_t values = std::int64_t{1} << (with_sign ? slot.bit_size - 1 : slot.bit_size);
  return slot.logical_max < values && slot.logical_min >= -values;
}

std::int64_t rawOfTime(const ValueSlot& slot, double time_s) noexcept {
  const double tick_s = isSeconds(slot.unit) ? std::pow(10.0, slot.unit_exponent) : 1e-3;
  return rounded(time_s / tick_s, slot);
}

std::optional<double> stepOfTime(const ValueSlot& slot) noexcept {
  if (slot.unit != 0 && !isSeconds(slot.unit)) return std::nullopt;
  const double unit_s = slot.unit != 0 ? std::pow(10.0, slot.unit_exponent) : 1e-3;
  const auto logical = static_cast<double>(slot.logical_max - slot.logical_min);
  const auto physical = static_cast<double>(slot.physical_max - slot.physical_min);
  return physical == 0 || logical == 0 ? unit_s : unit_s * physical / logical;
}

std::int64_t rawOfAngle(const ValueSlot& slot, double angle_deg) noexcept {
  const auto low = static_cast<double>(slot.logical_min);
  const std::int64_t steps = slot.logical_max - slot.logical_min;
  // A range like 0..35999 leaves out the end of the turn, one like 0..36000 or 0..255 has it.
  const auto turn = static_cast<double>((steps + 1) % 360 == 0 ? steps + 1 : steps);
  return rounded(low + angle_deg / 360 * turn, slot);
}

namespace {

constexpr std::uint16_t kDesktopPage = 0x01;
constexpr std::uint16_t kSimulationPage = 0x02;
constexpr std::uint16_t kButtonPage = 0x09;
constexpr std::uint16_t kPidPage = 0x0F;
constexpr std::uint16_t kX = 0x30;
constexpr std::uint16_t kSteering = 0xC8;
constexpr std::uint32_t kWidest = 32;

/// Usages of page 0x0F (Device Class Definition for Physical Interface Devices 1.0).
enum Pid : std::uint16_t {
  kSetEffect = 0x21,
  kBlockIndex = 0x22,
  kEffectType = 0x25,
  kConstantForceType = 0x26,
  kDuration = 0x50,
  kEffectGain = 0x52,
  kTriggerButton = 0x53,
  kAxesEnable = 0x55,
  kDirectionEnable = 0x56,
  kDirection = 0x57,
  kMagnitude = 0x70,
  kSetConstantForce = 0x73,
  kOperationReport = 0x77,
  kOperation = 0x78,
  kStart = 0x79,
  kStop = 0x7B,
  kLoopCount = 0x7C,
  kGainReport = 0x7D,
  kDeviceGain = 0x7E,
  kPoolReport = 0x7F,
  kBlockLoadReport = 0x89,
  kLoadStatus = 0x8B,
  kLoadSuccess = 0x8C,
  kLoadFull = 0x8D,
  kLoadError = 0x8E,
  kBlockFreeReport = 0x90,
  kStateReport = 0x92,
  kPlaying = 0x94,
  kControlReport = 0x95,
  kControl = 0x96,
  kEnableActuators = 0x97,
  kDisableActuators = 0x98,
  kStopAll = 0x99,
  kReset = 0x9A,
  kPaused = 0x9F,
  kActuatorsEnabled = 0xA0,
  kSafetySwitch = 0xA4,
  kActuatorPower = 0xA6,
  kCreateReport = 0xAB,
};

constexpr Usage pid(Pid id) { return {kPidPage, id}; }

ValueSlot slotOf(const HidField& field, std::uint32_t index) {
  return {field.bit_offset + index * field.bit_size,
          field.bit_size,
          field.logical_min,
          field.logical_max,
          field.unit_exponent,
          field.unit,
          field.physical_min,
          field.physical_max};
}

bool isUsable(const HidField& field) { return !field.constant && field.bit_size <= kWidest; }

/// The fields of one report: those of a type inside the collection that names the report.
class ReportFields {
 public:
  ReportFields(const ReportDescriptor& descriptor, ReportType type, Pid report) {
    for (const HidField& field : descriptor.fields()) {
      if (field.type != type || !field.isInside(pid(report))) continue;
      if (fields_.empty()) report_ = {field.report_id, descriptor.reportBytes(type, field.report_id)};
      if (field.report_id == report_.id && isUsable(field)) fields_.push_back(&field);
    }
  }

  explicit operator bool() const { return report_.bytes > 0; }
  const PidReport& report() const { return report_; }

  std::optional<ValueSlot> value(Pid usage) const {
    for (const HidField* field : fields_) {
      const auto index = field->indexOf(pid(usage));
      if (field->variable && index && *index < field->count) return slotOf(*field, *index);
    }
    return std::nullopt;
  }

  /// All values inside a collection, whatever their own usages are.
  std::vector<ValueSlot> values(Pid collection) const {
    std::vector<ValueSlot> slots;
    for (const HidField* field : fields_) {
      if (!field->variable || !field->isInside(pid(collection))) continue;
      for (std::uint32_t i = 0; i < std::min(field->count, 8U); ++i) slots.push_back(slotOf(*field, i));
    }
    return slots;
  }

  std::optional<PidChoice> choice(Pid option) const {
    for (const HidField* field : fields_) {
      const auto index = field->indexOf(pid(option));
      if (!index) continue;
      if (!field->variable) return PidChoice{slotOf(*field, 0), firstOption(*field) + *index};
      if (*index < field->count) return PidChoice{slotOf(*field, *index), 1};
    }
    return std::nullopt;
  }

 private:
  /// The number of the first option. A range from 0 with one value more than there are options means: 0 is none.
  static std::int64_t firstOption(const HidField& field) {
    const bool zero_is_none =
        field.logical_min == 0 && field.logical_max >= static_cast<std::int64_t>(field.usageCount());
    return zero_is_none ? 1 : field.logical_min;
  }

  PidReport report_;
  std::vector<const HidField*> fields_;
};

/// Collects what is missing, so that one sentence can name all of it.
class Finder {
 public:
  explicit Finder(const ReportDescriptor& descriptor) : descriptor_(descriptor) {}

  base::Result<PidLayout> find() {
    if (!claimsPid(descriptor_))
      return base::fail(base::ErrorCode::kData, "report descriptor", "no force-feedback reports",
                        "a force-feedback device (HID PID)");
    findEffect();
    findConstantForce();
    findOperation();
    findMemory();
    findOptionalReports();
    findState();
    findInputs();
    if (!missing_.empty())
      return base::fail(base::ErrorCode::kData, "report descriptor", "no " + base::joined(missing_, ", no "),
                        "a force-feedback device (HID PID) that plays constant forces");
    if (auto checked = checkLayout(layout_); !checked) return tl::unexpected(checked.error());
    return std::move(layout_);
  }

 private:
  template <class T>
  T need(std::optional<T> value, const char* what) {
    if (value) return *std::move(value);
    missing_.emplace_back(what);
    return {};
  }

  ReportFields need(ReportType type, Pid report, const char* what) {
    ReportFields fields(descriptor_, type, report);
    if (!fields) missing_.emplace_back(what);
    return fields;
  }

  void findEffect() {
    const ReportFields fields(descriptor_, ReportType::kOutput, kSetEffect);
    auto& out = layout_.set_effect;
    out.report = fields.report();
    out.block = need(fields.value(kBlockIndex), "block index in Set Effect");
    out.constant_force = need(fields.choice(kConstantForceType), "constant force among the effect types");
    out.duration = need(fields.value(kDuration), "duration in Set Effect");
    out.gain = fields.value(kEffectGain);
    out.trigger_button = fields.value(kTriggerButton);
    out.direction_enable = fields.value(kDirectionEnable);
    out.axes_enable = fields.values(kAxesEnable);
    out.directions = fields.values(kDirection);
    const std::size_t axes = out.axes_enable.empty() ? out.directions.size() : out.axes_enable.size();
    const bool can_choose = !out.directions.empty() || out.axes_enable.size() > 1;
    layout_.force_axes = axes > 1 && can_choose ? 2 : 1;
  }

  void findConstantForce() {
    const ReportFields fields = need(ReportType::kOutput, kSetConstantForce, "Set Constant Force report");
    if (!fields) return;
    auto& out = layout_.constant_force;
    out = {fields.report(), need(fields.value(kBlockIndex), "block index in Set Constant Force"),
           need(fields.value(kMagnitude), "magnitude in Set Constant Force")};
    if (out.magnitude.bit_size > 0 && layout_.signByDirection() && layout_.set_effect.directions.empty())
      missing_.emplace_back("direction beside a magnitude without a sign");
  }

  void findOperation() {
    const ReportFields fields = need(ReportType::kOutput, kOperationReport, "Effect Operation report");
    if (!fields) return;
    layout_.operation = {fields.report(), need(fields.value(kBlockIndex), "block index in Effect Operation"),
                         need(fields.choice(kStart), "start in Effect Operation"),
                         need(fields.choice(kStop), "stop in Effect Operation"), fields.value(kLoopCount)};
  }

  void findMemory() {
    if (const ReportFields fields = need(ReportType::kFeature, kCreateReport, "Create New Effect report"))
      layout_.create = {fields.report(),
                        need(fields.choice(kConstantForceType), "constant force in Create New Effect")};
    if (const ReportFields fields = need(ReportType::kFeature, kBlockLoadReport, "PID Block Load report"))
      layout_.block_load = {fields.report(), need(fields.value(kBlockIndex), "block index in PID Block Load"),
                            fields.choice(kLoadSuccess), fields.choice(kLoadFull), fields.choice(kLoadError)};
    if (const ReportFields fields(descriptor_, ReportType::kFeature, kPoolReport); fields)
      layout_.pool = fields.report();
    if (const ReportFields fields(descriptor_, ReportType::kOutput, kBlockFreeReport); fields) {
      if (const auto block = fields.value(kBlockIndex)) layout_.block_free = {fields.report(), *block};
    }
  }

  void findOptionalReports() {
    for (const Pid usage : {kControlReport, kControl}) {
      const ReportFields fields(descriptor_, ReportType::kOutput, usage);
      if (!fields || layout_.control) continue;
      layout_.control = {fields.report(), fields.choice(kEnableActuators), fields.choice(kDisableActuators),
                         fields.choice(kStopAll), fields.choice(kReset)};
    }
    if (const ReportFields fields(descriptor_, ReportType::kOutput, kGainReport); fields) {
      if (const auto gain = fields.value(kDeviceGain)) layout_.gain = {fields.report(), *gain};
    }
  }

  void findState() {
    const ReportFields fields(descriptor_, ReportType::kInput, kStateReport);
    if (!fields) return;
    layout_.state = {fields.report().id,          fields.value(kPaused),        fields.value(kActuatorsEnabled),
                     fields.value(kSafetySwitch), fields.value(kActuatorPower), fields.value(kPlaying),
                     fields.value(kBlockIndex)};
  }

  void findInputs() {
    for (const HidField& field : descriptor_.fields()) {
      if (field.type != ReportType::kInput || !field.variable || !isUsable(field) || field.usages.empty()) continue;
      for (std::uint32_t i = 0; i < field.count; ++i) {
        if (const auto usage = field.usageAt(i)) takeInput(field, i, *usage);
      }
    }
    if (!layout_.axes[0] && steering_) layout_.axes[0] = steering_;
    if (!layout_.axes[0] && !layout_.axes[1] && !layout_.axes[2]) missing_.emplace_back("position axis (X, Y, Z)");
  }

  void takeInput(const HidField& field, std::uint32_t index, const Usage& usage) {
    const InputSlot slot{field.report_id, slotOf(field, index)};
    const auto fill = [&](std::optional<InputSlot>& place) {
      if (!place) place = slot;
    };
    if (usage.page == kDesktopPage && usage.id >= kX && usage.id < kX + layout_.axes.size())
      fill(layout_.axes[usage.id - kX]);
    if (usage == Usage{kSimulationPage, kSteering}) fill(steering_);
    if (usage.page == kButtonPage && usage.id >= 1 && usage.id <= layout_.buttons.size() && field.bit_size == 1)
      fill(layout_.buttons[usage.id - 1U]);
  }

  const ReportDescriptor& descriptor_;
  PidLayout layout_;
  std::optional<InputSlot> steering_;
  std::vector<std::string> missing_;
};

}  // namespace

std::vector<std::uint8_t> PidReport::blank() const {
  std::vector<std::uint8_t> report_bytes(bytes);
  if (!report_bytes.empty()) report_bytes[0] = id;
  return report_bytes;
}

bool claimsPid(const ReportDescriptor& descriptor) {
  return descriptor.numbered() &&
         std::any_of(descriptor.fields().begin(), descriptor.fields().end(), [](const HidField& field) {
           return field.type == ReportType::kOutput && field.isInside(pid(kSetEffect));
         });
}

base::Result<PidLayout> PidLayout::find(const ReportDescriptor& descriptor) { return Finder(descriptor).find(); }

}  // namespace tactus::haptics
