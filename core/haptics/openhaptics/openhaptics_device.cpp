#include "core/haptics/openhaptics/openhaptics_device.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "core/haptics/device/seconds.h"
#include "core/haptics/openhaptics/openhaptics_info.h"

namespace tactus::haptics {
namespace {

constexpr int kQuietFrames = 30;                  ///< of zero force before the loop is stopped: the arm comes to rest
constexpr int kLongestWaitForQuiet = 100;         ///< ms; a driver that stands still is not waited for
constexpr std::uint64_t kCalibrationEvery = 100;  ///< frames between two looks
constexpr double kFadeS = 0.030;                  ///< a device that is sound lets a force go no faster than a release
constexpr std::int64_t kRecoverAfterNs = 500'000'000;

std::int64_t systemClockNs() {
  return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// The motors are warm, or the device refused a force: it is sound, and a hand may lean on what it gives.
bool fades(DeviceFault fault) noexcept {
  return fault == DeviceFault::kWarmMotors || fault == DeviceFault::kForceLimited;
}

double length(const Vector3& v) noexcept { return std::hypot(v.x, v.y, v.z); }

Vector3 shortened(const Vector3& v, double most) noexcept {
  const double now = length(v);
  return now > most ? (most / now) * v : v;
}

bool finite(const Vector3& v) noexcept { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

Vector3 readVector(const HdApi& api, std::uint32_t name) noexcept {
  double values[3] = {0, 0, 0};
  api.get_doublev(name, values);
  return {values[0], values[1], values[2]};
}

}  // namespace

OpenHapticsDevice::OpenHapticsDevice(std::shared_ptr<const HdLibrary> library, HdHandle handle, DeviceInfo info,
                                     int styles, OpenHapticsSettings settings)
    : library_(std::move(library)),
      api_(library_->api()),
      handle_(handle),
      info_(std::move(info)),
      settings_(std::move(settings)),
      calibration_(api_, styles) {
  calibration_.see();
  if (!settings_.clock_ns) settings_.clock_ns = systemClockNs;
  if (!settings_.pause) settings_.pause = [] { std::this_thread::sleep_for(std::chrono::milliseconds(1)); };
}

OpenHapticsDevice::~OpenHapticsDevice() {
  stop();
  api_.make_current_device(handle_);
  api_.disable_device(handle_);
  drainErrors(api_);
}

base::Result<void> OpenHapticsDevice::start() {
  if (started_) return {};
  api_.make_current_device(handle_);
  drainErrors(api_);
  calibration_.forgetRequest();
  calibration_.look();
  state_ = {};
  command_ = {};
  given_n_ = 0;
  fault_ = DeviceFault::kNone;
  quiet_frames_.store(0, std::memory_order_relaxed);
  stopping_.store(false, std::memory_order_relaxed);
  loop_over_.store(false, std::memory_order_relaxed);

  const HdErrors errors = startDriver();
  started_ = errors.count == 0;
  if (started_) return {};
  haltDriver();
  return base::fail(base::ErrorCode::kIo, info_.id, describe(api_, errors.gravest),
                    "a device that starts (is its supply on, is it still plugged in?)");
}

HdErrors OpenHapticsDevice::startDriver() {
  for (const auto capability : {hd::kForceOutput, hd::kMaxForceClamping, hd::kForceRamping}) api_.enable(capability);
  if (const auto errors = drainErrors(api_); errors.count > 0) return errors;
  schedule_ = api_.schedule_asynchronous(onFrame, this, hd::kHighestPriority);
  if (const auto errors = drainErrors(api_); errors.count > 0) return errors;
  scheduled_ = true;
  api_.set_scheduler_rate(settings_.rate_hz);
  if (const auto errors = drainErrors(api_); errors.count > 0) return errors;
  info_.rate_hz = static_cast<double>(settings_.rate_hz);
  api_.start_scheduler();
  return drainErrors(api_);
}

void OpenHapticsDevice::haltDriver() noexcept {
  api_.stop_scheduler();
  // A callback that said it was done is not in the schedule any more.
  if (scheduled_ && !loop_over_.load(std::memory_order_acquire)) api_.unschedule(schedule_);
  scheduled_ = false;
  api_.make_current_device(handle_);
  api_.disable(hd::kForceOutput);
  drainErrors(api_);
}

void OpenHapticsDevice::stop() noexcept {
  end();
  if (!started_) return;
  started_ = false;
  waitForQuiet();
  haltDriver();
}

void OpenHapticsDevice::waitForQuiet() noexcept {
  stopping_.store(true, std::memory_order_relaxed);
  for (int waited = 0; waited < kLongestWaitForQuiet; ++waited) {
    if (loop_over_.load(std::memory_order_acquire)) return;
    if (quiet_frames_.load(std::memory_order_acquire) >= kQuietFrames) return;
    settings_.pause();
  }
}

base::Result<void> OpenHapticsDevice::run(Ticked& ticked) {
  if (!started_ || loop_over_.load(std::memory_order_acquire))
    return base::fail(base::ErrorCode::kData, info_.id, "a loop that does not run", "a started device");
  end();
  ticked_ = &ticked;
  turn_.store(Turn::kTicking, std::memory_order_release);
  return {};
}

void OpenHapticsDevice::end() noexcept {
  for (;;) {
    Turn expected = Turn::kTicking;
    if (turn_.compare_exchange_strong(expected, Turn::kIdle, std::memory_order_acq_rel)) return;
    if (expected == Turn::kIdle) return;
    std::this_thread::yield();  // it is in a tick, which takes microseconds
  }
}

DeviceState OpenHapticsDevice::read(std::int64_t) noexcept { return state_; }

void OpenHapticsDevice::write(const Vector3& force_n, std::int64_t) noexcept {
  // Between ticks the driver's thread writes zero by itself, and the command is that thread's.
  if (turn_.load(std::memory_order_relaxed) != Turn::kInTick) return;
  if (!finite(force_n)) {
    command_ = {};
    return;
  }
  command_ = shortened(force_n, info_.max_force_n);
}

std::uint32_t OpenHapticsDevice::frame() noexcept {
  const std::int64_t now_ns = settings_.clock_ns();
  api_.begin_frame(handle_);
  if (state_.number % kCalibrationEvery == 0 || calibration_.requested()) calibration_.look();
  sample(now_ns);
  const bool ticked = tickProgram(now_ns);
  const Vector3 force = allowedForce(ticked, now_ns);
  given_n_ = length(force);
  const double values[3] = {force.x, force.y, force.z};
  api_.set_doublev(hd::kCurrentForce, values);
  api_.end_frame(handle_);

  const HdErrors errors = drainErrors(api_);
  if (errors.count == 0) state_.written_ns = now_ns;
  heed(errors, now_ns);
  if (errors.endsLoop()) {
    state_.fault = DeviceFault::kLost;
    tickProgram(now_ns);
    loop_over_.store(true, std::memory_order_release);
    return hd::kCallbackDone;
  }
  if (stopping_.load(std::memory_order_relaxed)) quiet_frames_.fetch_add(1, std::memory_order_release);
  return hd::kCallbackContinue;
}

void OpenHapticsDevice::sample(std::int64_t now_ns) noexcept {
  ++state_.number;
  state_.time_ns = now_ns;
  state_.position_mm = readVector(api_, hd::kCurrentPosition);
  const Vector3 velocity = readVector(api_, hd::kCurrentVelocity);
  state_.velocity_mm_s = finite(velocity) ? std::optional(velocity) : std::nullopt;
  int buttons = 0;
  api_.get_integerv(hd::kCurrentButtons, &buttons);
  state_.buttons = static_cast<std::uint32_t>(buttons);
  const bool uncalibrated = fault_ == DeviceFault::kNone && !calibration_.calibrated();
  state_.fault = uncalibrated ? DeviceFault::kNotCalibrated : fault_;
}

bool OpenHapticsDevice::tickProgram(std::int64_t now_ns) noexcept {
  Turn expected = Turn::kTicking;
  if (!turn_.compare_exchange_strong(expected, Turn::kInTick, std::memory_order_acq_rel)) {
    command_ = {};
    return false;
  }
  ticked_->tick(now_ns);
  turn_.store(Turn::kTicking, std::memory_order_release);
  return true;
}

Vector3 OpenHapticsDevice::allowedForce(bool ticked, std::int64_t now_ns) const noexcept {
  if (!ticked || stopping_.load(std::memory_order_relaxed)) return {};
  if (state_.fault == DeviceFault::kNone) return command_;
  if (!fades(state_.fault)) return {};
  const double left = 1 - secondsBetween(faulted_ns_, now_ns) / kFadeS;
  return left > 0 ? shortened(command_, std::min(given_n_, left * fading_n_)) : Vector3{};
}

void OpenHapticsDevice::heed(const HdErrors& errors, std::int64_t now_ns) noexcept {
  if (errors.count > 0) {
    last_error_.store(errors.gravest.code, std::memory_order_relaxed);
    last_internal_.store(errors.gravest.internal_code, std::memory_order_relaxed);
    if (fault_ == DeviceFault::kNone) {
      faulted_ns_ = now_ns;
      fading_n_ = given_n_;
    }
    fault_ = errors.fault;
    unforced_since_ns_ = now_ns;
  } else if (fault_ != DeviceFault::kNone) {
    recover(now_ns);
  }
}

void OpenHapticsDevice::recover(std::int64_t now_ns) noexcept {
  if (command_ != Vector3{}) unforced_since_ns_ = now_ns;
  if (now_ns - unforced_since_ns_ < kRecoverAfterNs) return;
  // The driver switches the output off with a force error; its ramp brings the forces back slowly.
  if (api_.is_enabled(hd::kForceOutput) == 0) api_.enable(hd::kForceOutput);
  const HdErrors errors = drainErrors(api_);
  if (errors.count == 0) fault_ = DeviceFault::kNone;
  unforced_since_ns_ = now_ns;
}

std::optional<std::string> OpenHapticsDevice::lastError() const {
  HdErrorRecord error;
  error.code = last_error_.load(std::memory_order_relaxed);
  if (error.code == hd::kSuccess) return std::nullopt;
  error.internal_code = last_internal_.load(std::memory_order_relaxed);
  error.device = handle_;
  return describe(api_, error);
}

}  // namespace tactus::haptics
