#include "core/haptics/haply/haply_device.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "core/base/text.h"
#include "core/haptics/haply/haply_messages.h"
#include "core/haptics/haply/web_socket.h"
#include "core/haptics/servo/servo_clock.h"

namespace tactus::haptics {
namespace {

using base::ErrorCode;
using base::Result;

constexpr double kPatienceS = 1;  // a service of this computer that is silent for longer is dead
constexpr double kLookS = 0.02;   // between two looks at whether to end
constexpr std::int64_t kRetryNs = 500'000'000;
constexpr std::int64_t kNapNs = 100'000;         // the thread looks for a new command this often
constexpr std::int64_t kServoNs = 2'000'000;     // a servo that decides nothing for so long is not waited for
constexpr std::int64_t kAbsentNs = 100'000'000;  // between two questions for a device that is not listed
// The service says only that a device is idle if no commands come, not after what time. So a short time, and our own
// end.
constexpr double kHoldS = 0.02;
constexpr double kLetGoS = 0.005;
constexpr int kTrials = 100;
constexpr int kMostWaiting = 256;  // messages that were not asked for, taken at once
constexpr double kTickS = 0.001;
/// A later state gives no force (stale_zero_s in safety/limit_settings.h).
constexpr double kLatestS = 0.02;
constexpr double kMmPerM = 1000;

std::string placeOf(std::uint16_t port) { return "localhost:" + std::to_string(port); }

tl::unexpected<base::Error> notAService(std::uint16_t port, std::string found) {
  return base::fail(ErrorCode::kIo, placeOf(port), std::move(found), "a Haply Inverse Service, format 3.1 or later");
}

Result<std::unique_ptr<WebSocketClient>> connectTo(std::uint16_t port) {
  return WebSocketClient::connect("Haply Inverse Service", port, kPatienceS);
}

/// The first message of the service lists its devices.
Result<HaplyMessage> receiveList(WebSocketClient& socket, std::uint16_t port) {
  TACTUS_TRY(const auto text, socket.receive(kPatienceS));
  if (!text) return notAService(port, "no message within " + base::formatNumber(kPatienceS) + " s");
  auto message = readHaplyMessage(*text);
  if (!message) return notAService(port, message.error().message());
  if (!message->error.empty()) return notAService(port, "the error " + base::quoted(message->error));
  return message;
}

struct RoundTrips {
  double typical_s = 0;  ///< median
  double slow_s = 0;     ///< 99 % are faster
};

/// Of kTrials questions without a force.
Result<RoundTrips> measureRoundTrips(WebSocketClient& socket, std::uint16_t port, const std::string& device_id) {
  std::vector<double> times_s;
  const std::int64_t begin_ns = monotonicNs();
  const std::string probe = haplyProbeText(device_id);
  while (static_cast<int>(times_s.size()) < kTrials && secondsBetween(begin_ns, monotonicNs()) < kPatienceS) {
    const std::int64_t sent_ns = monotonicNs();
    if (auto sent = socket.send(probe); !sent) return tl::unexpected(sent.error());
    TACTUS_TRY(const auto text, socket.receive(kPatienceS));
    if (!text) return notAService(port, "no reply within " + base::formatNumber(kPatienceS) + " s");
    times_s.push_back(secondsBetween(sent_ns, monotonicNs()));
  }
  std::sort(times_s.begin(), times_s.end());
  return RoundTrips{times_s[times_s.size() / 2], times_s[(times_s.size() - 1) * 99 / 100]};
}

/// Positions in another order, turned or scaled would make other millimeters and newtons.
bool hasOtherAxes(const HaplyReport& report) { return report.basis && *report.basis != "XYZ"; }

void judge(const HaplyReport& report, double round_trip_s, HaplyFound& found) {
  if (hasOtherAxes(report)) {
    found.problem = "its axes are in the order " + base::quoted(*report.basis);
    found.advice = "set its basis to XYZ in the Haply Hub";
  } else if (report.is_mounted_otherwise) {
    found.problem = "its positions are turned or scaled by its mount";
    found.advice = "choose the preset `defaults` in the Haply Hub";
  } else if (round_trip_s > kLatestS) {
    found.problem = "it replies in " + base::formatFixed(1e3 * round_trip_s, 1) + " ms, too late for a force";
    found.advice = "close other programs that use it, and connect it without a hub";
  } else if (!found.calibrated) {
    found.advice = "calibrate it as its maker says, in the Haply Hub";
  }
}

HaplyFound foundOf(const HaplyReport& report, bool has_grip, const RoundTrips& trips) {
  HaplyFound found;
  DeviceInfo& info = found.info;
  info.simulated = report.is_simulated.value_or(false);
  info.id = (info.simulated ? "simulated-haply:" : "haply:") + report.id;
  info.name = info.simulated ? "Haply Inverse3 (simulated)" : "Haply Inverse3";
  info.serial = report.id;
  info.backend = "haply";
  info.position_axes = 3;
  info.force_axes = 3;
  info.buttons = has_grip ? 3 : 0;
  info.max_force_n = kHaplyMaxForceN;
  // The servo answers a state at its next tick, and the thread of the device sees the answer after a nap.
  info.delay_s = trips.slow_s + kTickS + 1e-9 * static_cast<double>(kNapNs);
  info.hold_s = kHoldS;
  found.round_trip_s = trips.slow_s;
  found.calibrated = report.is_calibrated.value_or(true);
  const bool is_centered = report.preset && report.preset->ends_with("_centered");
  if (!is_centered) found.middle_mm = kMmPerM * fromHaplyAxes(kHaplyMiddleM);
  judge(report, trips.typical_s, found);
  return found;
}

}  // namespace

Result<std::vector<HaplyFound>> lookAtHaply(std::uint16_t port) {
  TACTUS_TRY(const auto socket, connectTo(port));
  TACTUS_TRY(const auto list, receiveList(*socket, port));
  std::vector<HaplyFound> all;
  if (list.devices.empty()) return all;
  TACTUS_TRY(const RoundTrips trips, measureRoundTrips(*socket, port, list.devices.front().id));
  for (const HaplyReport& report : list.devices) all.push_back(foundOf(report, !list.grips.empty(), trips));
  return all;
}

Result<std::unique_ptr<HaplyDevice>> HaplyDevice::open(std::uint16_t port, const std::string& id) {
  TACTUS_TRY(auto all, lookAtHaply(port));
  for (HaplyFound& found : all) {
    if (!id.empty() && found.info.id != id) continue;
    if (found.problem.empty()) return std::unique_ptr<HaplyDevice>(new HaplyDevice(port, std::move(found)));
    return base::fail(ErrorCode::kIo, found.info.id, found.problem, found.advice);
  }
  if (id.empty())
    return base::fail(ErrorCode::kReference, placeOf(port), "no device", "an Inverse3, connected and switched on");
  return base::fail(ErrorCode::kReference, id, "no such device", "one that `tactus devices` lists");
}

HaplyDevice::~HaplyDevice() { stop(); }

Result<void> HaplyDevice::start() {
  stop();
  TACTUS_TRY(auto socket, connectTo(port_));
  state_ = {};
  states_.put(state_);
  commands_.put({});
  is_listed_ = is_force_out_ = false;
  for (auto* const count : {&state_count_, &refused_, &reconnects_}) count->store(0, std::memory_order_relaxed);
  ends_.store(false, std::memory_order_release);
  thread_ = startDeviceThread([this, opened = std::move(socket)]() mutable { run(std::move(opened)); });
  return {};
}

void HaplyDevice::stop() noexcept {
  ends_.store(true, std::memory_order_release);
  if (thread_.joinable()) thread_.join();
}

DeviceState HaplyDevice::read(std::int64_t /*now_ns*/) noexcept { return states_.take(); }

void HaplyDevice::write(const Vector3& force_n, std::int64_t now_ns) noexcept {
  commands_.put({force_n, now_ns, true});
}

HaplyCounters HaplyDevice::counters() const noexcept {
  return {state_count_.load(std::memory_order_relaxed), refused_.load(std::memory_order_relaxed),
          reconnects_.load(std::memory_order_relaxed)};
}

// On the thread of the device.

void HaplyDevice::pause(std::int64_t duration_ns) const {
  constexpr std::int64_t kSliceNs = 10'000'000;
  for (std::int64_t left_ns = duration_ns; left_ns > 0 && !ends_.load(std::memory_order_acquire); left_ns -= kSliceNs)
    std::this_thread::sleep_for(std::chrono::nanoseconds(std::min(left_ns, kSliceNs)));
}

void HaplyDevice::run(std::unique_ptr<WebSocketClient> socket) {
  for (;;) {
    if (socket) exchange(*socket);
    if (ends_.load(std::memory_order_acquire)) break;
    socket.reset();
    is_force_out_ = false;
    refuse(DeviceFault::kLost);
    pause(kRetryNs);
    if (ends_.load(std::memory_order_acquire)) return;
    auto again = connectTo(port_);
    if (!again) continue;
    socket = std::move(*again);
    reconnects_.fetch_add(1, std::memory_order_relaxed);
  }
  if (socket && socket->send(haplyForceText(found_.info.serial, {}))) (void)socket->receive(0.1);
}

/// Until the connection ends, or the device is to stop.
void HaplyDevice::exchange(WebSocketClient& socket) {
  std::int64_t heard_ns = monotonicNs();
  while (!ends_.load(std::memory_order_acquire)) {
    const auto text = socket.receive(kLookS);
    if (!text) return;
    if (!*text) {
      if (secondsBetween(heard_ns, monotonicNs()) > kPatienceS) return;
      continue;
    }
    onMessage(**text);
    // A service that sends more than it is asked for would make old states of new ones.
    for (int i = 0; i < kMostWaiting && socket.hasMore(); ++i) {
      const auto newer = socket.receive(kLookS);
      if (!newer) return;
      if (*newer) onMessage(**newer);
    }
    if (!socket.send(nextCommand())) return;
    heard_ns = monotonicNs();
  }
}

void HaplyDevice::onMessage(std::string_view text) {
  const auto message = readHaplyMessage(text);
  if (message) return takeReport(*message);
  refused_.fetch_add(1, std::memory_order_relaxed);
  refuse(DeviceFault::kFailed);
}

void HaplyDevice::takeReport(const HaplyMessage& message) {
  const auto& all = message.devices;
  const auto report =
      std::find_if(all.begin(), all.end(), [&](const HaplyReport& r) { return r.id == found_.info.serial; });
  // A service that was started anew may be another one, or have other settings.
  const bool simulated = found_.info.simulated;
  is_listed_ = report != all.end() && report->is_simulated.value_or(simulated) == simulated && !hasOtherAxes(*report) &&
               !report->is_mounted_otherwise;
  if (!is_listed_) return refuse(DeviceFault::kLost);
  if (!message.error.empty() || !report->position_m) {
    refused_.fetch_add(1, std::memory_order_relaxed);
    return refuse(DeviceFault::kFailed);
  }
  const std::int64_t now_ns = monotonicNs();
  ++state_.number;
  state_.time_ns = now_ns;
  state_.position_mm = kMmPerM * fromHaplyAxes(*report->position_m);
  state_.velocity_mm_s.reset();
  if (report->velocity_m_s) state_.velocity_mm_s = kMmPerM * fromHaplyAxes(*report->velocity_m_s);
  // Grips and devices have no link; with as many of both, they belong together in their order.
  const auto index = static_cast<std::size_t>(report - all.begin());
  const auto& grips = message.grips;
  state_.buttons = grips.empty() ? 0 : grips[grips.size() == all.size() ? index : 0];
  if (is_force_out_) state_.written_ns = now_ns;
  is_force_out_ = false;
  state_.fault = DeviceFault::kNone;
  if (!report->is_powered.value_or(true)) state_.fault = DeviceFault::kSwitchedOff;
  if (!report->is_calibrated.value_or(true)) state_.fault = DeviceFault::kNotCalibrated;
  state_count_.fetch_add(1, std::memory_order_relaxed);
  states_.put(state_);
}

/// The sample stays, with its age.
void HaplyDevice::refuse(DeviceFault fault) {
  state_.fault = fault;
  states_.put(state_);
}

/// Waits for the servo's decision on the state that was just taken.
std::string HaplyDevice::nextCommand() {
  if (!is_listed_ && state_.fault == DeviceFault::kLost) {
    pause(kAbsentNs);
    return haplyFullStateText();
  }
  const std::int64_t begin_ns = monotonicNs();
  while (!commands_.fresh() && monotonicNs() - begin_ns < kServoNs && !ends_.load(std::memory_order_acquire))
    std::this_thread::sleep_for(std::chrono::nanoseconds(kNapNs));
  const Vector3 force_n = state_.fault == DeviceFault::kNone ? forceNow(monotonicNs()) : Vector3{};
  is_force_out_ = true;
  return haplyForceText(found_.info.serial, force_n);
}

/// The newest command, but none that is older than the hold time, is no number, or is beyond the largest force.
Vector3 HaplyDevice::forceNow(std::int64_t now_ns) {
  const Command& command = commands_.take();
  const double size_n = std::sqrt(dot(command.force_n, command.force_n));
  if (!command.valid || !std::isfinite(size_n)) return {};
  const double over_s = secondsBetween(command.time_ns, now_ns) - kHoldS;
  const double left = std::clamp(1 - over_s / kLetGoS, 0.0, 1.0);
  return left * std::min(1.0, size_n > 0 ? kHaplyMaxForceN / size_n : 1.0) * command.force_n;
}

}  // namespace tactus::haptics
