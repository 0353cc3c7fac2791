#include "core/haptics/simulated/replay_device.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/error.h"
#include "core/base/text.h"

namespace tactus::haptics {
namespace {

using base::ErrorCode;
using base::fail;

constexpr double kLongestS = 1e6;

std::int64_t nearestNanosecond(double seconds) { return std::llround(seconds * 1e9); }

const study::Channel* find(const study::Recording& recording, std::string_view name) {
  for (const auto& channel : recording.channels)
    if (channel.name == name) return &channel;
  return nullptr;
}

std::string placeOf(const study::Channel& channel) { return "recording: channel " + base::quoted(channel.name); }

/// Of the right unit and length, and finite.
base::Result<void> check(const study::Channel& channel, std::string_view unit, std::size_t size) {
  if (channel.unit != unit)
    return fail(ErrorCode::kValue, placeOf(channel), "unit " + base::quoted(channel.unit),
                "unit " + base::quoted(unit));
  if (channel.values.size() != size)
    return fail(ErrorCode::kData, placeOf(channel), std::to_string(channel.values.size()) + " samples",
                std::to_string(size) + ", as in the first channel");
  for (std::size_t i = 0; i < size; ++i)
    if (!std::isfinite(channel.values[i]))
      return fail(ErrorCode::kValue, placeOf(channel) + ", sample " + std::to_string(i + 1),
                  base::formatNumber(channel.values[i]), "a finite number");
  return {};
}

/// Times of the samples from 0, rising.
base::Result<std::vector<std::int64_t>> timesOf(const study::Recording& recording) {
  std::vector<std::int64_t> times_ns(recording.size());
  const study::Channel* const time = find(recording, "time");
  if (time == nullptr) {
    const double rate_hz = recording.sample_rate_hz;
    const double length_s = static_cast<double>(recording.size() - 1) / rate_hz;
    if (!(rate_hz > 0 && rate_hz <= 1e9 && length_s <= kLongestS))
      return fail(ErrorCode::kValue, "recording: sample rate", base::formatNumber(rate_hz) + " Hz",
                  "a rate above 0 Hz and at most 1e9 Hz, for at most 1e6 s");
    const double period_ns = 1e9 / rate_hz;
    for (std::size_t i = 0; i < times_ns.size(); ++i) times_ns[i] = std::llround(static_cast<double>(i) * period_ns);
    return times_ns;
  }
  if (auto ok = check(*time, "s", recording.size()); !ok) return tl::unexpected(std::move(ok.error()));
  for (std::size_t i = 1; i < times_ns.size(); ++i) {
    const double since_start_s = time->values[i] - time->values.front();
    if (since_start_s <= kLongestS && since_start_s > 0) times_ns[i] = nearestNanosecond(since_start_s);
    if (times_ns[i] <= times_ns[i - 1])
      return fail(ErrorCode::kData, placeOf(*time) + ", sample " + std::to_string(i + 1),
                  base::formatNumber(time->values[i]) + " s after " + base::formatNumber(time->values[i - 1]) + " s",
                  "times that rise, within 1e6 s");
  }
  return times_ns;
}

DeviceInfo describe() {
  DeviceInfo info;
  info.id = "replay";
  info.name = "Replay of a recording (simulated)";
  info.backend = "replay";
  info.simulated = true;
  info.max_force_n = 3.3;  // goes nowhere; a Touch's, so that limits act as they would on one
  info.delay_s = 0;
  return info;
}

}  // namespace

base::Result<std::unique_ptr<ReplayDevice>> ReplayDevice::make(const study::Recording& recording,
                                                               const ReplaySettings& settings) {
  const study::Channel* position = find(recording, "position");
  if (position == nullptr) position = find(recording, "depth");
  if (position == nullptr)
    return fail(ErrorCode::kData, "recording", "no channel of positions", "a channel 'position' or 'depth'");
  if (recording.size() < 2)
    return fail(ErrorCode::kData, "recording", std::to_string(recording.size()) + " samples", "at least 2");
  if (auto ok = check(*position, "mm", recording.size()); !ok) return tl::unexpected(std::move(ok.error()));
  TACTUS_TRY(auto times_ns, timesOf(recording));
  std::vector<bool> down(recording.size(), true);
  if (const study::Channel* const button = find(recording, "button")) {
    if (auto ok = check(*button, "1", recording.size()); !ok) return tl::unexpected(std::move(ok.error()));
    std::transform(button->values.begin(), button->values.end(), down.begin(), [](double value) { return value != 0; });
  }
  if (!(settings.lead_s >= 0 && settings.lead_s <= 100))
    return fail(ErrorCode::kValue, "replay: lead_s", base::formatNumber(settings.lead_s), "a number in [0, 100]");
  if (!(settings.return_s >= 0.01 && settings.return_s <= 100))
    return fail(ErrorCode::kValue, "replay: return_s", base::formatNumber(settings.return_s),
                "a number in [0.01, 100]");
  return std::unique_ptr<ReplayDevice>(
      new ReplayDevice(std::move(times_ns), position->values, std::move(down), settings));
}

ReplayDevice::ReplayDevice(std::vector<std::int64_t> time_ns, std::vector<double> position_mm, std::vector<bool> button,
                           const ReplaySettings& settings)
    : time_ns_(std::move(time_ns)),
      position_mm_(std::move(position_mm)),
      button_(std::move(button)),
      settings_(settings),
      lead_ns_(nearestNanosecond(settings.lead_s)),
      return_ns_(nearestNanosecond(settings.return_s)),
      way_back_(stroke(position_mm_.front() - position_mm_.back(), settings.return_s)),
      info_(describe()) {}

base::Result<void> ReplayDevice::start() {
  clock_ = {};
  last_ = {};
  last_position_mm_ = position_mm_.front();
  forces_.clear();
  forces_.reserve(settings_.room_for_forces);
  forces_lost_ = 0;
  running_ = true;
  return {};
}

ReplayDevice::Frame ReplayDevice::at(std::int64_t elapsed_ns) const noexcept {
  const std::int64_t played_ns = (settings_.loop ? elapsed_ns % (lengthNs() + return_ns_) : elapsed_ns) - lead_ns_;
  if (played_ns < 0) return {position_mm_.front(), false};
  if (played_ns > time_ns_.back()) {
    if (!settings_.loop) return {position_mm_.back(), false};
    return {position_mm_.back() + way_back_(1e-9 * static_cast<double>(played_ns - time_ns_.back())).position_mm,
            false};
  }
  const auto after = std::upper_bound(time_ns_.begin(), time_ns_.end(), played_ns);
  if (after == time_ns_.end()) return {position_mm_.back(), button_.back()};
  const auto i = static_cast<std::size_t>(after - time_ns_.begin());
  const double share =
      static_cast<double>(played_ns - time_ns_[i - 1]) / static_cast<double>(time_ns_[i] - time_ns_[i - 1]);
  return {position_mm_[i - 1] + (position_mm_[i] - position_mm_[i - 1]) * share, button_[i - 1]};
}

DeviceState ReplayDevice::read(std::int64_t now_ns) noexcept {
  if (!running_) return last_;
  const Frame frame = at(clock_.at(now_ns));
  ++last_.number;
  last_.time_ns = now_ns;
  last_position_mm_ = frame.position_mm;
  last_.position_mm = frame.position_mm * settings_.inwards;
  last_.buttons = frame.button ? 1 : 0;
  return last_;
}

void ReplayDevice::write(const Vector3& force_n, std::int64_t now_ns) noexcept {
  if (!running_) return;
  last_.written_ns = now_ns;
  if (forces_.size() < settings_.room_for_forces) {
    forces_.push_back({now_ns, last_position_mm_, force_n});
  } else {
    ++forces_lost_;
  }
}

}  // namespace tactus::haptics
