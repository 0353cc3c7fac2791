#include "core/haptics/hid/pid_session.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/error.h"

namespace tactus::haptics {
namespace {

void putChoice(std::vector<std::uint8_t>& report, const PidChoice& choice) {
  putValue(report, choice.slot, choice.value);
}

bool says(std::span<const std::uint8_t> report, const std::optional<PidChoice>& choice) {
  return choice && takeValue(report, choice->slot) == choice->value;
}

}  // namespace

PidSession::PidSession(HidTransport& transport, PidLayout layout, std::function<void(int)> pause,
                       std::function<std::int64_t()> now_ns)
    : transport_(transport), layout_(std::move(layout)), pause_(std::move(pause)), now_ns_(std::move(now_ns)) {}

std::vector<std::int64_t> PidSession::blocks() const {
  std::vector<std::int64_t> blocks;
  for (const Effect& effect : effects_) blocks.push_back(effect.block);
  return blocks;
}

std::int64_t PidSession::startedNs() const {
  std::int64_t started_ns = effects_.empty() ? 0 : effects_.front().started_ns;
  for (const Effect& effect : effects_) started_ns = std::min(started_ns, effect.started_ns);
  return started_ns;
}

PidSession::Done PidSession::askPool() {
  if (!layout_.pool) return {};
  // The answer is not needed; some firmwares set up their memory when they are asked, others refuse.
  auto report = layout_.pool->blank();
  const std::int64_t asked_ns = now_ns_();
  const bool answered = transport_.getFeature(report).has_value();
  if (answered || now_ns_() - asked_ns < kSilentNs) return {};
  return base::fail(base::ErrorCode::kIo, "device", "no answer to the first question",
                    "a device that answers (unplug it, then plug it in again)");
}

PidSession::Done PidSession::control(const std::optional<PidChoice> PidLayout::Control::*what) {
  if (!layout_.control || !((*layout_.control).*what)) return {};
  auto report = layout_.control->report.blank();
  putChoice(report, *((*layout_.control).*what));
  return transport_.write(report);
}

PidSession::Done PidSession::begin(std::int64_t now_ns) {
  effects_.clear();
  if (auto asked = askPool(); !asked) return asked;
  Done done = control(&PidLayout::Control::reset);
  if (done) done = control(&PidLayout::Control::enable);
  if (done && layout_.gain) {
    auto report = layout_.gain->report.blank();
    putValue(report, layout_.gain->gain, layout_.gain->gain.logical_max);
    done = transport_.write(report);
  }
  for (int axis = 0; done && axis < layout_.force_axes; ++axis)
    done = createEffect(static_cast<std::size_t>(axis), now_ns);
  if (!done) leave();
  return done;
}

PidSession::Done PidSession::createEffect(std::size_t axis, std::int64_t now_ns) {
  auto report = layout_.create.report.blank();
  putChoice(report, layout_.create.constant_force);
  if (auto done = transport_.sendFeature(report); !done) return done;
  TACTUS_TRY(const auto block, loadedBlock());
  for (const ValueSlot& slot : {layout_.set_effect.block, layout_.constant_force.block, layout_.operation.block}) {
    if (block <= allOnes(slot)) continue;
    return base::fail(base::ErrorCode::kData, "force effect", "block " + std::to_string(block) + " of the device",
                      "at most " + std::to_string(allOnes(slot)) + ", as its other reports have room for");
  }
  effects_.push_back({});
  Effect& effect = effects_.back();
  effect.block = block;
  if (auto done = setEffect(axis, false); !done) return done;
  const auto none = layout_.signByDirection() ? layout_.constant_force.magnitude.logical_min : 0;
  if (auto done = setMagnitude(effect, none, now_ns); !done) return done;
  effect.started_ns = now_ns;
  return operate(effect, layout_.operation.start);
}

base::Result<std::int64_t> PidSession::loadedBlock() {
  const auto& load = layout_.block_load;
  for (int poll = 0; poll < kLoadPolls; ++poll) {
    if (poll > 0) pause_(1);
    auto report = load.report.blank();
    if (const auto read = transport_.getFeature(report); !read) return tl::unexpected(read.error());
    if (says(report, load.full))
      return base::fail(base::ErrorCode::kLimit, "force effect", "no room for it in the device",
                        "a free effect (close other programs that use the device)");
    if (says(report, load.error))
      return base::fail(base::ErrorCode::kIo, "force effect", "an error of the device", "a loaded effect");
    const std::int64_t block = takeValue(report, load.block);
    if (block > 0 && (!load.success || says(report, load.success))) return block;
  }
  return base::fail(base::ErrorCode::kIo, "force effect", "no answer of the device after 60 questions",
                    "a loaded effect");
}

PidSession::Done PidSession::setEffect(std::size_t axis, bool turned) {
  const auto& effect = layout_.set_effect;
  auto report = effect.report.blank();
  putValue(report, effect.block, effects_[axis].block);
  putChoice(report, effect.constant_force);
  putValue(report, effect.duration, rawOfTime(effect.duration, kDurationS));
  if (effect.gain) putValue(report, *effect.gain, effect.gain->logical_max);
  if (effect.trigger_button) putValue(report, *effect.trigger_button, allOnes(*effect.trigger_button));
  if (!effect.directions.empty()) {
    // Polar, 0 is north (y), 90 degrees is east (x). Whether a firmware pushes or pulls is calibrated.
    const double angle_deg = (axis == 0 ? 90.0 : 0.0) + (turned ? 180.0 : 0.0);
    putValue(report, effect.directions[0], rawOfAngle(effect.directions[0], angle_deg));
    if (effect.direction_enable) putValue(report, *effect.direction_enable, 1);
  }
  // As the Linux kernel does it: with a direction enabled no single axis is.
  if ((effect.directions.empty() || !effect.direction_enable) && axis < effect.axes_enable.size())
    putValue(report, effect.axes_enable[axis], 1);
  auto done = transport_.write(report);
  if (done) effects_[axis].turned = turned;
  return done;
}

PidSession::Done PidSession::setMagnitude(Effect& effect, std::int64_t raw, std::int64_t now_ns) {
  auto report = layout_.constant_force.report.blank();
  putValue(report, layout_.constant_force.block, effect.block);
  putValue(report, layout_.constant_force.magnitude, raw);
  effect.sent.reset();
  auto done = transport_.write(report);
  if (done) {
    effect.sent = raw;
    effect.sent_ns = now_ns;
  }
  return done;
}

PidSession::Done PidSession::operate(const Effect& effect, const PidChoice& what) {
  auto report = layout_.operation.report.blank();
  putValue(report, layout_.operation.block, effect.block);
  putChoice(report, what);
  if (layout_.operation.loop_count) putValue(report, *layout_.operation.loop_count, 1);
  return transport_.write(report);
}

PidSession::Done PidSession::send(const std::array<double, 2>& shares, std::int64_t now_ns) {
  for (std::size_t axis = 0; axis < effects_.size(); ++axis) {
    if (auto done = sendAxis(axis, shares[axis], now_ns); !done) return done;
  }
  return {};
}

PidSession::Done PidSession::sendAxis(std::size_t axis, double share, std::int64_t now_ns) {
  Effect& effect = effects_[axis];
  const ValueSlot& slot = layout_.constant_force.magnitude;
  const bool turned = layout_.signByDirection() && share < 0;
  const std::int64_t raw = rawOfShare(slot, layout_.signByDirection() ? std::abs(share) : share);
  if (layout_.signByDirection() && turned != effect.turned && raw != slot.logical_min) {
    // The old magnitude must not act in the new direction.
    if (effect.sent != slot.logical_min) {
      if (auto done = setMagnitude(effect, slot.logical_min, now_ns); !done) return done;
    }
    if (auto done = setEffect(axis, turned); !done) return done;
  }
  if (effect.sent != raw || now_ns - effect.sent_ns >= kRefreshNs) {
    if (auto done = setMagnitude(effect, raw, now_ns); !done) return done;
  }
  if (now_ns - effect.started_ns >= kRestartNs) {
    if (auto done = operate(effect, layout_.operation.start); !done) return done;
    effect.started_ns = now_ns;
  }
  return {};
}

bool PidSession::leave() noexcept {
  bool complete = true;
  int failed_in_a_row = 0;
  const auto attempt = [&](auto write) {
    if (failed_in_a_row == 2) return;
    const bool written = write().has_value();
    failed_in_a_row = written ? 0 : failed_in_a_row + 1;
    complete = complete && written;
  };
  const auto none = layout_.signByDirection() ? layout_.constant_force.magnitude.logical_min : 0;
  for (Effect& effect : effects_) attempt([&] { return setMagnitude(effect, none, effect.sent_ns); });
  for (Effect& effect : effects_) attempt([&] { return operate(effect, layout_.operation.stop); });
  for (const Effect& effect : effects_) {
    attempt([&]() -> Done {
      if (!layout_.block_free) return {};
      auto report = layout_.block_free->report.blank();
      putValue(report, layout_.block_free->block, effect.block);
      return transport_.write(report);
    });
  }
  attempt([&] { return control(&PidLayout::Control::stop_all); });
  attempt([&] { return control(&PidLayout::Control::disable); });
  effects_.clear();
  return complete;
}

}  // namespace tactus::haptics
