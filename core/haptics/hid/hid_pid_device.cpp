#include "core/haptics/hid/hid_pid_device.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/haptics/device/device.h"
#include "core/haptics/device/device_threads.h"

namespace tactus::haptics {

PidInput::PidInput(const PidLayout& layout, std::span<const std::int64_t> blocks) : layout_(layout) {
  effect_count_ = std::min(blocks.size(), effects_.size());
  for (std::size_t i = 0; i < effect_count_; ++i) effects_[i].block = blocks[i];
}

bool PidInput::watchEffects(std::int64_t now_ns, std::int64_t started_ns, std::int64_t duration_ns) noexcept {
  const auto silent = [](const Effect& effect) { return effect.had_played && !effect.plays; };
  const bool any_silent = std::any_of(effects_.begin(), effects_.end(), silent);
  const bool should_play = now_ns - started_ns >= kSettleNs && now_ns - started_ns < duration_ns;
  // In between it is not known: a start is on its way, or the effects have run out.
  if (should_play || !any_silent) effect_stopped_ = any_silent;
  const bool before = sample_.forces_held_back;
  sample_.forces_held_back = switched_off_ || effect_stopped_;
  return sample_.forces_held_back != before;
}

bool PidInput::take(std::span<const std::uint8_t> report, std::int64_t now_ns) noexcept {
  if (report.empty()) return false;
  const std::uint8_t id = report[0];
  bool taken = false;
  if (layout_.state && layout_.state->report_id == id) {
    takeState(report);
    taken = true;
  }
  bool moved = false;
  for (std::size_t axis = 0; axis < layout_.axes.size(); ++axis) {
    const auto& input = layout_.axes[axis];
    if (!input || input->report_id != id) continue;
    const ValueSlot& slot = input->slot;
    if (1 + (slot.bit_offset + slot.bit_size + 7) / 8 > report.size()) continue;
    const std::int64_t middle = (slot.logical_min + slot.logical_max + 1) / 2;
    sample_.counts[axis] = static_cast<double>(takeValue(report, slot) - middle);
    moved = true;
  }
  for (std::size_t i = 0; i < layout_.buttons.size(); ++i) {
    const auto& input = layout_.buttons[i];
    if (!input || input->report_id != id) continue;
    const std::uint32_t bit = std::uint32_t{1} << i;
    sample_.buttons = takeValue(report, input->slot) != 0 ? sample_.buttons | bit : sample_.buttons & ~bit;
    taken = true;
  }
  if (moved) {
    ++sample_.number;
    sample_.time_ns = now_ns;
  }
  return taken || moved;
}

void PidInput::takeState(std::span<const std::uint8_t> report) noexcept {
  const auto& state = *layout_.state;
  const auto is = [&](const std::optional<ValueSlot>& slot) { return slot && takeValue(report, *slot) != 0; };
  had_switch_ = had_switch_ || is(state.safety_switch);
  had_power_ = had_power_ || is(state.power);
  switched_off_ = is(state.paused) || (state.actuators_on && !is(state.actuators_on)) ||
                  (had_switch_ && !is(state.safety_switch)) || (had_power_ && !is(state.power));
  takePlaying(report);
  sample_.forces_held_back = switched_off_ || effect_stopped_;
}

void PidInput::takePlaying(std::span<const std::uint8_t> report) noexcept {
  const auto& state = *layout_.state;
  if (!state.playing) return;
  const bool plays = takeValue(report, *state.playing) != 0;
  const std::int64_t block = state.block ? takeValue(report, *state.block) : 0;
  for (std::size_t i = 0; i < effect_count_; ++i) {
    Effect& effect = effects_[i];
    // Without a block it is about all of them.
    if (block != 0 && block != effect.block) continue;
    effect.plays = plays;
    effect.had_played = effect.had_played || plays;
  }
}

std::array<double, 2> PidWriter::sharesOf(const Vector3& force_n) const {
  if (!std::isfinite(force_n.x) || !std::isfinite(force_n.y) || !std::isfinite(force_n.z)) return {};
  const auto axes = hidAxesOf({sign_.x * force_n.x, sign_.y * force_n.y, sign_.z * force_n.z});
  return {std::clamp(axes[0] / full_scale_n_, -1.0, 1.0), std::clamp(axes[1] / full_scale_n_, -1.0, 1.0)};
}

base::Result<void> PidWriter::step(std::int64_t now_ns) {
  const PidCommand& command = commands_.take();
  const double over_s = secondsBetween(command.time_ns, now_ns) - PidSession::kHoldS;
  const double left = command.valid ? std::clamp(1 - over_s / kLetGoS, 0.0, 1.0) : 0;
  command_ns_ = command.time_ns;
  auto shares = sharesOf(command.force_n);
  for (double& share : shares) share *= left;
  auto sent = session_.send(shares, now_ns);
  let_go_ = left == 0 && sent.has_value();
  return sent;
}

bool PidWriter::letsGo(std::int64_t now_ns) const noexcept {
  return !let_go_ && secondsBetween(command_ns_, now_ns) > PidSession::kHoldS;
}

namespace {

constexpr int kReadTimeoutMs = 5;
constexpr int kMostWaiting = 256;         // reports per round of the reader; the kernel keeps 64
constexpr std::int64_t kNapNs = 200'000;  // the writer looks for a new command this often
constexpr std::int64_t kAfterFailureNs = 2'000'000;
constexpr std::int64_t kProofOfLifeNs = 20'000'000;  // a write so recent shows that a silent device is still there
constexpr double kUsbDelayS = 0.0025;                // full-speed interrupt transfers there and back, and a tick

}  // namespace

base::Result<std::unique_ptr<HidPidDevice>> HidPidDevice::open(std::unique_ptr<HidTransport> transport,
                                                               const HidIdentity& identity,
                                                               const std::optional<DeviceCalibration>& calibration,
                                                               HidPidTiming timing) {
  if (calibration) {
    if (auto checked = checkCalibration(*calibration); !checked) return tl::unexpected(checked.error());
  }
  TACTUS_TRY(const auto bytes, transport->descriptor());
  const auto descriptor = ReportDescriptor::parse(bytes);
  if (!descriptor) return base::inFile(descriptor.error(), identity.id);
  auto layout = PidLayout::find(*descriptor);
  if (!layout) return base::inFile(layout.error(), identity.id);
  if (calibration) {
    const double driven = drivenShare(calibration->inwards, drivenAxes(layout->force_axes));
    if (driven < kLeastDrivenShare)
      return base::inFile(
          base::fail(base::ErrorCode::kValue, "insertion axis",
                     "a cosine of " + base::formatFixed(driven, 2) + " to the motors",
                     "at least " + base::formatNumber(kLeastDrivenShare) + " (calibrate it again, along its motors)")
              .value(),
          identity.id);
  }
  std::unique_ptr<HidPidDevice> device(new HidPidDevice(std::move(transport), *std::move(layout), std::move(timing)));
  device->describe(identity, calibration);
  return device;
}

HidPidDevice::HidPidDevice(std::unique_ptr<HidTransport> transport, PidLayout layout, HidPidTiming timing)
    : transport_(std::move(transport)), layout_(std::move(layout)), timing_(std::move(timing)) {
  if (!timing_.now_ns) {
    timing_.now_ns = [] {
      const auto since = std::chrono::steady_clock::now().time_since_epoch();
      return static_cast<std::int64_t>(std::chrono::duration_cast<std::chrono::nanoseconds>(since).count());
    };
  }
  if (!timing_.pause)
    timing_.pause = [](std::int64_t ns) { std::this_thread::sleep_for(std::chrono::nanoseconds(ns)); };
}

HidPidDevice::~HidPidDevice() { stop(); }

void HidPidDevice::describe(const HidIdentity& identity, const std::optional<DeviceCalibration>& calibration) {
  calibrated_ = calibration.has_value();
  if (calibration) {
    calibration_ = *calibration;
    // Not above 1 by the rounding of a file.
    driven_share_ = std::min(drivenShare(calibration->inwards, drivenAxes(layout_.force_axes)), 1.0);
  } else {
    calibration_.full_scale_n = 1;
    calibration_.mm_per_count = 1;
  }
  info_.id = identity.id;
  info_.name = identity.name;
  info_.serial = identity.serial;
  info_.backend = "hid-pid";
  const auto has = [](const auto& slot) { return slot.has_value(); };
  info_.position_axes = static_cast<int>(std::count_if(layout_.axes.begin(), layout_.axes.end(), has));
  info_.force_axes = layout_.force_axes;
  info_.buttons = static_cast<int>(std::count_if(layout_.buttons.begin(), layout_.buttons.end(), has));
  info_.max_force_n = driven_share_ * calibration_.full_scale_n;
  info_.delay_s = kUsbDelayS;
  info_.hold_s = PidSession::kHoldS;
  info_.quiet_after_s = PidSession::kQuietAfterS;
  if (!calibration) return;
  info_.count_mm = calibration->mm_per_count;
  info_.calibrated_utc = calibration->measured_at;
  info_.friction_in_n = calibration->friction_in_n;
  info_.friction_out_n = calibration->friction_out_n;
}

base::Result<void> HidPidDevice::start() {
  stop();
  samples_.put({});
  lost_.store(false, std::memory_order_relaxed);
  written_ns_.store(0, std::memory_order_relaxed);
  dropWaitingReports();
  session_.emplace(
      *transport_, layout_, [this](int ms) { timing_.pause(std::int64_t{ms} * 1'000'000); }, timing_.now_ns);
  if (auto begun = session_->begin(timing_.now_ns()); !begun) {
    session_.reset();
    return base::inFile(begun.error(), info_.id);
  }
  writer_.emplace(*session_, calibration_, driven_share_);
  started_ns_.store(session_->startedNs(), std::memory_order_relaxed);
  reader_ends_.store(false, std::memory_order_relaxed);
  writer_ends_.store(false, std::memory_order_relaxed);
  reader_ = startDeviceThread([this, blocks = session_->blocks()] { readerLoop(blocks); });
  writer_thread_ = startDeviceThread([this] { writerLoop(); });
  return {};
}

void HidPidDevice::stop() noexcept {
  writer_ends_.store(true, std::memory_order_release);
  if (writer_thread_.joinable()) writer_thread_.join();
  reader_ends_.store(true, std::memory_order_release);
  if (reader_.joinable()) reader_.join();
  // The box of commands stays: the servo may still write into it while it is told to end.
}

DeviceState HidPidDevice::read(std::int64_t /*now_ns*/) noexcept {
  const PidSample& sample = samples_.take();
  DeviceState state;
  state.number = sample.number;
  state.time_ns = sample.time_ns;
  state.position_mm = calibration_.mm_per_count * fromHidAxes(sample.counts);
  state.buttons = sample.buttons;
  state.written_ns = written_ns_.load(std::memory_order_acquire);
  if (lost_.load(std::memory_order_acquire)) {
    state.fault = DeviceFault::kLost;
  } else if (sample.forces_held_back) {
    state.fault = DeviceFault::kSwitchedOff;
  } else if (!calibrated_) {
    state.fault = DeviceFault::kNotCalibrated;
  }
  return state;
}

void HidPidDevice::write(const Vector3& force_n, std::int64_t now_ns) noexcept {
  if (writer_) writer_->commands().put({force_n, now_ns, true});
}

HidPidCounters HidPidDevice::counters() const noexcept {
  return {reports_.load(std::memory_order_relaxed), rounds_.load(std::memory_order_relaxed),
          failed_rounds_.load(std::memory_order_relaxed), longest_round_ns_.load(std::memory_order_relaxed)};
}

/// The kernel has kept the oldest reports since the device was open last: where the handle was then, and its buttons.
void HidPidDevice::dropWaitingReports() {
  std::array<std::uint8_t, 8193> room{};
  for (int i = 0; i < kMostWaiting; ++i) {
    const auto length = transport_->readTimeout(room, 0);
    if (!length || *length == 0) return;  // a device that is gone fails at the next question
  }
}

void HidPidDevice::readerLoop(const std::vector<std::int64_t>& blocks) {
  PidInput input(layout_, blocks);
  std::array<std::uint8_t, 8193> room{};
  while (!reader_ends_.load(std::memory_order_acquire)) {
    if (!drain(input, room)) {
      lost_.store(true, std::memory_order_release);
      return;
    }
  }
}

bool HidPidDevice::drain(PidInput& input, std::span<std::uint8_t> room) {
  // The kernel keeps old reports and drops new ones, so everything that waits is taken at once.
  bool changed = false;
  for (int i = 0; i < kMostWaiting; ++i) {
    const auto length = transport_->readTimeout(room, i == 0 ? kReadTimeoutMs : 0);
    if (!length) return false;
    if (*length == 0) break;
    reports_.fetch_add(1, std::memory_order_relaxed);
    changed = input.take(room.first(std::min(*length, room.size())), timing_.now_ns()) || changed;
  }
  constexpr auto kDurationNs = static_cast<std::int64_t>(1e9 * PidSession::kDurationS);
  changed = input.watchEffects(timing_.now_ns(), started_ns_.load(std::memory_order_relaxed), kDurationNs) || changed;
  if (!changed && calibration_.silent_when_still && input.sample().number > 0) {
    const std::int64_t now = timing_.now_ns();
    changed = now - written_ns_.load(std::memory_order_acquire) < kProofOfLifeNs;
    if (changed) input.renew(now);
  }
  if (changed) samples_.put(input.sample());
  return true;
}

void HidPidDevice::writerLoop() {
  std::int64_t last_ns = 0;
  while (!writer_ends_.load(std::memory_order_acquire)) {
    if (lost_.load(std::memory_order_acquire)) return;  // nothing is left to be made quiet
    const std::int64_t now = timing_.now_ns();
    if (!writer_->commands().fresh() && !writer_->letsGo(now) && now - last_ns < PidSession::kRefreshNs) {
      timing_.pause(kNapNs);
      continue;
    }
    last_ns = now;
    if (!writerRound()) timing_.pause(kAfterFailureNs);
  }
  session_->leave();
}

bool HidPidDevice::writerRound() {
  const std::int64_t begin = timing_.now_ns();
  const bool through = writer_->step(begin).has_value();
  const std::int64_t end = timing_.now_ns();
  if (through) started_ns_.store(session_->startedNs(), std::memory_order_relaxed);
  if (through) written_ns_.store(end, std::memory_order_release);
  (through ? rounds_ : failed_rounds_).fetch_add(1, std::memory_order_relaxed);
  longest_round_ns_.store(std::max(longest_round_ns_.load(std::memory_order_relaxed), end - begin),
                          std::memory_order_relaxed);
  return through;
}

}  // namespace tactus::haptics
