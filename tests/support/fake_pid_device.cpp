#include "tests/support/fake_pid_device.h"

#include <algorithm>
#include <cmath>

namespace tactus::support {
namespace {

constexpr std::int64_t kMs = 1'000'000;
constexpr double kPi = 3.14159265358979323846;
constexpr double kFullTurn = 2 * kPi;

/// Byte offsets of a model, byte 0 being the id; 0: the value is not there.
struct Bytes {
  std::uint8_t effect_id, constant_id, operation_id, free_id, control_id, gain_id;
  std::uint8_t create_id, load_id, pool_id, input_id, state_id;
  std::size_t effect_length, gain, gain_width, trigger, axes, direction, direction_width;
  double gain_full, turn;  ///< raw value of the full gain, and of 360 degrees
  std::uint8_t direction_bit, constant_type, types;
  double magnitude_full;
  int effects;
};

const Bytes& bytesOf(PidModel model) {
  static constexpr Bytes kBoard{.effect_id = 0x01,
                                .constant_id = 0x05,
                                .operation_id = 0x0A,
                                .free_id = 0x0B,
                                .control_id = 0x0C,
                                .gain_id = 0x0D,
                                .create_id = 0x11,
                                .load_id = 0x12,
                                .pool_id = 0x13,
                                .input_id = 0x01,
                                .state_id = 0x02,
                                .effect_length = 22,
                                .gain = 11,
                                .gain_width = 1,
                                .trigger = 12,
                                .axes = 13,
                                .direction = 14,
                                .direction_width = 2,
                                .gain_full = 255,
                                .turn = 36000,
                                .direction_bit = 4,
                                .constant_type = 1,
                                .types = 11,
                                .magnitude_full = 32767,
                                .effects = 40};
  static constexpr Bytes kSketch{.effect_id = 1,
                                 .constant_id = 5,
                                 .operation_id = 10,
                                 .free_id = 11,
                                 .control_id = 12,
                                 .gain_id = 13,
                                 .create_id = 5,
                                 .load_id = 6,
                                 .pool_id = 7,
                                 .input_id = 3,
                                 .state_id = 2,
                                 .effect_length = 18,
                                 .gain = 9,
                                 .gain_width = 1,
                                 .trigger = 10,
                                 .axes = 11,
                                 .direction = 12,
                                 .direction_width = 1,
                                 .gain_full = 255,
                                 .turn = 255,
                                 .direction_bit = 4,
                                 .constant_type = 1,
                                 .types = 12,
                                 .magnitude_full = 10000,
                                 .effects = 14};
  static constexpr Bytes kWheel{.effect_id = 0x41,
                                .constant_id = 0x45,
                                .operation_id = 0x4A,
                                .free_id = 0x4B,
                                .control_id = 0x4C,
                                .gain_id = 0x4D,
                                .create_id = 0x51,
                                .load_id = 0x52,
                                .pool_id = 0,
                                .input_id = 0x44,
                                .state_id = 0,
                                .effect_length = 11,
                                .gain = 5,
                                .gain_width = 2,
                                .trigger = 7,
                                .axes = 8,
                                .direction = 9,
                                .direction_width = 2,
                                .gain_full = 10000,
                                .turn = 36000,
                                .direction_bit = 2,
                                .constant_type = 3,
                                .types = 4,
                                .magnitude_full = 10000,
                                .effects = 16};
  if (model == PidModel::kBoard) return kBoard;
  return model == PidModel::kSketch ? kSketch : kWheel;
}

unsigned number(std::span<const std::uint8_t> report, std::size_t at, std::size_t width) {
  return width == 1 ? report[at] : report[at] | static_cast<unsigned>(report[at + 1]) << 8U;
}

void put16(std::vector<std::uint8_t>& report, std::size_t at, int value) {
  report[at] = static_cast<std::uint8_t>(value);
  report[at + 1] = static_cast<std::uint8_t>(static_cast<unsigned>(value) >> 8U);
}

}  // namespace

FakePidDevice::FakePidDevice(PidModel model)
    : model_(model), effects_(static_cast<std::size_t>(bytesOf(model).effects)) {}

int FakePidDevice::forceAxes() const { return model_ == PidModel::kWheel ? 1 : 2; }

bool FakePidDevice::hasLength(std::span<const std::uint8_t> report, std::size_t length) {
  if (report.size() == length) return true;
  complain("report " + std::to_string(report[0]) + " has " + std::to_string(report.size()) + " bytes instead of " +
           std::to_string(length));
  return false;
}

FakePidDevice::Effect* FakePidDevice::effectOf(std::uint8_t block) {
  if (block >= 1 && block <= effects_.size() && effects_[block - 1].used) return &effects_[block - 1];
  complain("no effect in block " + std::to_string(block));
  return nullptr;
}

void FakePidDevice::output(std::span<const std::uint8_t> report, std::int64_t now_ns) {
  advance(now_ns);
  const Bytes& at = bytesOf(model_);
  if (report.empty()) return complain("an empty report");
  const std::uint8_t id = report[0];
  if (id == at.effect_id) {
    setEffect(report);
  } else if (id == at.constant_id) {
    setConstantForce(report);
  } else if (id == at.operation_id) {
    operate(report, now_ns);
  } else if (id == at.free_id) {
    if (Effect* effect = hasLength(report, 2) ? effectOf(report[1]) : nullptr) *effect = {};
  } else if (id == at.control_id) {
    control(report);
  } else if (id == at.gain_id) {
    if (hasLength(report, 2)) device_gain_ = report[1] / 255.0;
  } else {
    complain("unknown report " + std::to_string(id));
  }
  log(now_ns);
}

void FakePidDevice::setEffect(std::span<const std::uint8_t> report) {
  const Bytes& at = bytesOf(model_);
  if (!hasLength(report, at.effect_length)) return;
  Effect* effect = effectOf(report[1]);
  if (effect == nullptr) return;
  if (report[2] != at.constant_type) complain("effect type " + std::to_string(report[2]) + " is not a constant force");
  if (report[at.trigger] != 0xFF) complain("a trigger button was set");
  effect->duration_ms = static_cast<int>(number(report, 3, 2));
  effect->gain = number(report, at.gain, at.gain_width) / at.gain_full;
  if ((report[at.axes] & at.direction_bit) == 0) return complain("direction not enabled");
  const double angle = number(report, at.direction, at.direction_width) / at.turn * kFullTurn;
  if (model_ == PidModel::kBoard) effect->direction = {-std::sin(angle), std::cos(angle)};
  if (model_ == PidModel::kSketch) effect->direction = {std::sin(angle), -std::cos(angle)};
  if (model_ == PidModel::kWheel) effect->direction = {std::sin(angle), 0};
}

void FakePidDevice::setConstantForce(std::span<const std::uint8_t> report) {
  if (!hasLength(report, 4)) return;
  Effect* effect = effectOf(report[1]);
  if (effect == nullptr) return;
  const unsigned raw = number(report, 2, 2);
  const double value = model_ == PidModel::kWheel ? static_cast<double>(raw) : static_cast<std::int16_t>(raw);
  effect->magnitude = value / bytesOf(model_).magnitude_full;
  if (std::abs(effect->magnitude) > 1) complain("magnitude " + std::to_string(raw) + " is out of range");
}

void FakePidDevice::operate(std::span<const std::uint8_t> report, std::int64_t now_ns) {
  if (!hasLength(report, 4)) return;
  Effect* effect = effectOf(report[1]);
  if (effect == nullptr) return;
  operated_ = report[1];
  if (report[2] == 1) {
    if (report[3] != 1) complain("loop count " + std::to_string(report[3]));
    effect->playing = true;
    effect->started_ns = now_ns;
  } else if (report[2] == 3) {
    effect->playing = false;
  } else {
    complain("effect operation " + std::to_string(report[2]));
  }
}

void FakePidDevice::control(std::span<const std::uint8_t> report) {
  if (!hasLength(report, 2)) return;
  enum { kEnable = 1, kDisable, kStopAll, kReset };
  int command = report[1];
  if (model_ == PidModel::kBoard) {
    command = report[1] == 1   ? kEnable
              : report[1] == 2 ? kDisable
              : report[1] == 4 ? kStopAll
              : report[1] == 8 ? kReset
                               : 0;
  } else if (model_ == PidModel::kWheel && command <= 2) {
    command = command == 1 ? kDisable : command == 2 ? kEnable : 0;
  }
  if (command == kEnable) actuators_on_ = true;
  if (command == kDisable) actuators_on_ = false;
  if (command == kStopAll) {
    for (Effect& effect : effects_) effect.playing = false;
  }
  if (command == kReset) {
    std::fill(effects_.begin(), effects_.end(), Effect{});
    operated_ = 0;
    actuators_on_ = false;
  }
  if (command < kEnable || command > kReset) complain("device control " + std::to_string(report[1]));
}

bool FakePidDevice::setFeature(std::span<const std::uint8_t> report, std::int64_t now_ns) {
  advance(now_ns);
  const Bytes& at = bytesOf(model_);
  const std::size_t length = model_ == PidModel::kWheel ? 2 : 4;
  if (report.empty() || report[0] != at.create_id || !hasLength(report, length)) {
    complain("a feature report that creates nothing");
    return false;
  }
  if (report[1] < 1 || report[1] > at.types) complain("effect type " + std::to_string(report[1]));
  const auto free = std::find_if(effects_.begin(), effects_.end(), [](const Effect& effect) { return !effect.used; });
  created_ = free == effects_.end() ? 0 : static_cast<int>(free - effects_.begin()) + 1;
  if (free != effects_.end()) *free = Effect{.used = true};
  load_polls_ = 0;
  return true;
}

std::vector<std::uint8_t> FakePidDevice::getFeature(std::uint8_t id) {
  const Bytes& at = bytesOf(model_);
  if (id == at.load_id) {
    std::vector<std::uint8_t> report(5, 0);
    report[0] = id;
    // The wheel needs a while before its answer is there.
    const bool ready = model_ != PidModel::kWheel || ++load_polls_ > 3;
    if (created_ >= 0 && ready) {
      report[1] = static_cast<std::uint8_t>(created_);
      report[2] = created_ > 0 ? 1 : 2;
    }
    put16(report, 3, 1000);
    return report;
  }
  if (id == at.pool_id && at.pool_id != 0) {
    std::vector<std::uint8_t> report(5, 0);
    report[0] = id;
    put16(report, 1, 1000);
    report[3] = static_cast<std::uint8_t>(at.effects);
    report[4] = 1;
    return report;
  }
  return {};
}

std::vector<std::uint8_t> FakePidDevice::inputReport(std::array<int, 2> counts, std::uint32_t buttons) const {
  std::vector<std::uint8_t> report;
  if (model_ == PidModel::kBoard) {
    report.resize(25);
    for (std::size_t i = 0; i < 4; ++i) report[1 + i] = static_cast<std::uint8_t>(buttons >> (8 * i));
    put16(report, 9, counts[0]);
    put16(report, 11, counts[1]);
  } else if (model_ == PidModel::kSketch) {
    report.resize(6);
    report[1] = static_cast<std::uint8_t>(buttons);
    put16(report, 2, counts[0]);
    put16(report, 4, counts[1]);
  } else {
    report.resize(5);
    put16(report, 1, counts[0] + 32768);
    put16(report, 3, static_cast<int>(buttons & 0x0FFFU));
  }
  report[0] = bytesOf(model_).input_id;
  return report;
}

std::vector<std::uint8_t> FakePidDevice::stateReport() const {
  const bool on = actuators_on_ && !safety_switch_;
  // The bit of the safety switch: 1 is "the switch allows forces".
  const int bits = (on ? 2 : 0) | (safety_switch_ ? 0 : 4);
  if (model_ == PidModel::kBoard) {
    const bool any = std::any_of(effects_.begin(), effects_.end(), [](const Effect& effect) { return effect.playing; });
    return {0x02, static_cast<std::uint8_t>(bits | 8 | (any ? 16 : 0))};
  }
  if (model_ == PidModel::kSketch) {
    const bool plays = operated_ > 0 && effects_[operated_ - 1].playing;
    return {2, static_cast<std::uint8_t>(bits | 16), static_cast<std::uint8_t>((plays ? 1 : 0) | operated_ << 1)};
  }
  return {};
}

void FakePidDevice::pressSafetySwitch(bool down, std::int64_t now_ns) {
  advance(now_ns);
  safety_switch_ = down;
  log(now_ns);
}

bool FakePidDevice::runs(const Effect& effect, std::int64_t now_ns) {
  if (!effect.used || !effect.playing) return false;
  return effect.duration_ms == 0xFFFF || now_ns - effect.started_ns < effect.duration_ms * kMs;
}

std::array<double, 2> FakePidDevice::force(std::int64_t now_ns) const {
  std::array<double, 2> sum{};
  if (!actuators_on_ || safety_switch_) return sum;
  for (const Effect& effect : effects_) {
    if (!runs(effect, now_ns)) continue;
    for (std::size_t i = 0; i < 2; ++i) sum[i] += effect.magnitude * effect.direction[i] * effect.gain * device_gain_;
  }
  return sum;
}

int FakePidDevice::effectsInUse() const {
  return static_cast<int>(std::count_if(effects_.begin(), effects_.end(), [](const Effect& e) { return e.used; }));
}

int FakePidDevice::effectsPlaying(std::int64_t now_ns) const {
  return static_cast<int>(
      std::count_if(effects_.begin(), effects_.end(), [&](const Effect& e) { return runs(e, now_ns); }));
}

void FakePidDevice::advance(std::int64_t now_ns) {
  std::vector<std::int64_t> ends;
  for (const Effect& effect : effects_) {
    if (effect.used && effect.playing && !runs(effect, now_ns))
      ends.push_back(effect.started_ns + effect.duration_ms * kMs);
  }
  std::sort(ends.begin(), ends.end());
  for (const std::int64_t end : ends) log(end);
  for (Effect& effect : effects_) effect.playing = runs(effect, now_ns);
}

void FakePidDevice::log(std::int64_t now_ns) {
  const auto share = force(now_ns);
  if (forces_.empty() ? share != std::array<double, 2>{} : share != forces_.back().share)
    forces_.push_back({now_ns, share});
}

}  // namespace tactus::support
