#include "core/haptics/openhaptics/openhaptics_device.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <thread>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/haptics/device/device.h"
#include "core/haptics/openhaptics/openhaptics_info.h"

namespace tactus::haptics {
namespace {

constexpr int kLongestStack = 64;

const char* meaning(std::uint32_t code) noexcept {
  switch (code) {
    case hd::kWarmMotors: return "the motors are too warm";
    case hd::kExceededMaxForce: return "a force above the maximum was refused";
    case hd::kExceededMaxForceImpulse: return "a force that rose too fast was refused";
    case hd::kExceededMaxVelocity: return "the stylus moved too fast for forces";
    case hd::kForceError: return "the device could not give the force";
    case hd::kDeviceFault: return "the device reports a fault";
    case hd::kDeviceAlreadyInitiated: return "the device is open already";
    case hd::kCommError: return "the device does not answer";
    case hd::kCommConfigError: return "the connection is not set up";
    case hd::kTimerError: return "the driver's timer failed";
    case hd::kIllegalBegin:
    case hd::kIllegalEnd:
    case hd::kFrameError: return "the driver's frame was broken";
    case hd::kSchedulerFull: return "the driver takes no further callback";
    case hd::kInvalidLicence: return "the driver's license is not valid";
    default: return "the driver reports an error";
  }
}

std::string hexadecimal(std::uint32_t code) {
  std::array<char, 8> digits{};
  int used = 0;
  do {
    digits[static_cast<std::size_t>(used++)] = "0123456789abcdef"[code & 15u];
    code >>= 4;
  } while (code != 0 || used < 4);
  return "0x" + std::string(digits.rend() - used, digits.rend());
}

/// Larger counts more.
int gravity(DeviceFault fault) noexcept {
  switch (fault) {
    case DeviceFault::kNone: return 0;
    case DeviceFault::kForceLimited: return 1;
    case DeviceFault::kWarmMotors: return 2;
    case DeviceFault::kLost: return 4;
    default: return 3;
  }
}

}  // namespace

DeviceFault faultOf(std::uint32_t code) noexcept {
  if (code == hd::kSuccess) return DeviceFault::kNone;
  if (endsLoop(code)) return DeviceFault::kLost;
  if (code == hd::kWarmMotors) return DeviceFault::kWarmMotors;
  return code > hd::kWarmMotors && code <= hd::kForceError ? DeviceFault::kForceLimited : DeviceFault::kFailed;
}

bool endsLoop(std::uint32_t code) noexcept {
  return code == hd::kCommError || code == hd::kTimerError || code == hd::kIllegalBegin || code == hd::kIllegalEnd;
}

HdErrors drainErrors(const HdApi& api) noexcept {
  HdErrors errors;
  while (errors.count < kLongestStack) {
    const HdErrorRecord error = api.get_error();
    if (error.code == hd::kSuccess) break;
    if (errors.count++ == 0) errors.newest = error;
    const DeviceFault fault = faultOf(error.code);
    if (gravity(fault) <= gravity(errors.fault)) continue;
    errors.fault = fault;
    errors.gravest = error;
  }
  return errors;
}

std::string describe(const HdApi& api, const HdErrorRecord& error) {
  std::string text = std::string(meaning(error.code)) + " (" + hexadecimal(error.code);
  if (error.internal_code != 0) text += ", internal " + std::to_string(error.internal_code);
  const char* const words = api.get_error_string(error.code);
  if (words != nullptr && *words != '\0') text += ", " + base::quoted(words);
  return text + ")";
}

namespace {

constexpr const char* kPlace = "OpenHaptics library";

/// Looks up one function; notes the name of a missing one.
template <class Function>
void find(void* library, const char* name, Function& function, std::vector<std::string>& missing) {
  void* const symbol = dlsym(library, name);
  if (symbol == nullptr) missing.emplace_back(name);
  function = reinterpret_cast<Function>(symbol);
}

std::vector<std::string> findAll(void* library, HdApi& api) {
  std::vector<std::string> missing;
  find(library, "hdInitDevice", api.init_device, missing);
  find(library, "hdDisableDevice", api.disable_device, missing);
  find(library, "hdMakeCurrentDevice", api.make_current_device, missing);
  find(library, "hdBeginFrame", api.begin_frame, missing);
  find(library, "hdEndFrame", api.end_frame, missing);
  find(library, "hdGetError", api.get_error, missing);
  find(library, "hdGetErrorString", api.get_error_string, missing);
  find(library, "hdEnable", api.enable, missing);
  find(library, "hdDisable", api.disable, missing);
  find(library, "hdIsEnabled", api.is_enabled, missing);
  find(library, "hdGetString", api.get_string, missing);
  find(library, "hdGetIntegerv", api.get_integerv, missing);
  find(library, "hdGetDoublev", api.get_doublev, missing);
  find(library, "hdSetDoublev", api.set_doublev, missing);
  find(library, "hdCheckCalibration", api.check_calibration, missing);
  find(library, "hdUpdateCalibration", api.update_calibration, missing);
  find(library, "hdStartScheduler", api.start_scheduler, missing);
  find(library, "hdStopScheduler", api.stop_scheduler, missing);
  find(library, "hdSetSchedulerRate", api.set_scheduler_rate, missing);
  find(library, "hdScheduleAsynchronous", api.schedule_asynchronous, missing);
  find(library, "hdUnschedule", api.unschedule, missing);
  return missing;
}

std::string lastLoaderError() {
  const char* const text = dlerror();
  return base::oneLine(text == nullptr ? "no reason given" : text);
}

}  // namespace

const std::vector<std::string>& HdLibrary::defaultNames() {
  static const std::vector<std::string> names = {"libHD.so", "libHD.so.3.4"};
  return names;
}

base::Result<std::shared_ptr<const HdLibrary>> HdLibrary::load(const std::string& path) {
  const std::vector<std::string> names = path.empty() ? defaultNames() : std::vector<std::string>{path};
  std::vector<std::string> reasons;
  for (const auto& name : names) {
    // Global, because the driver's own libraries look for symbols of one another.
    void* const library = dlopen(name.c_str(), RTLD_NOW | RTLD_GLOBAL);
    if (library == nullptr) {
      reasons.push_back(lastLoaderError());
      continue;
    }
    std::shared_ptr<HdLibrary> loaded(new HdLibrary);
    loaded->path_ = name;
    const auto missing = findAll(library, loaded->api_);
    if (missing.empty()) return loaded;
    return base::fail(base::ErrorCode::kReference, kPlace, name + " without " + base::joined(missing, ", "),
                      "the HD library of OpenHaptics 3.4");
  }
  std::string wanted =
      "the OpenHaptics 3.4 runtime (libHD.so) and the Touch driver (libPhantomIOLib42.so) of 3D Systems";
  const std::string advice = hdEnvironmentAdvice();
  if (!advice.empty()) wanted += ", and " + advice;
  return base::fail(base::ErrorCode::kIo, kPlace,
                    "none that loads, tried " + base::joined(names, ", ") + " (" + base::joined(reasons, "; ") + ")",
                    wanted);
}

std::string hdEnvironmentAdvice() {
  const char* const home = std::getenv("GTDD_HOME");
  if (home == nullptr || *home == '\0')
    return "GTDD_HOME set to the folder of the device's configuration (the driver's default is ~/.3dsystems or "
           "/usr/share/3DSystems)";
  std::error_code ignored;
  if (std::filesystem::is_directory(home, ignored)) return {};
  return "the folder that GTDD_HOME names, " + base::quoted(home) + ", which is not there";
}

namespace {

/// The style to update with; 0: none of those known.
std::uint32_t chosenStyle(int styles, bool also_reset) noexcept {
  const auto mask = static_cast<std::uint32_t>(styles);
  if ((mask & hd::kInkwell) != 0) return hd::kInkwell;
  if ((mask & hd::kAutomatic) != 0) return hd::kAutomatic;
  return also_reset && (mask & hd::kEncoderReset) != 0 ? hd::kEncoderReset : 0u;
}

}  // namespace

std::string calibrationAdvice(int styles) {
  switch (chosenStyle(styles, true)) {
    case hd::kInkwell: return "put the stylus into the inkwell and leave it there for a second";
    case hd::kAutomatic: return "move the stylus slowly through its whole space";
    case hd::kEncoderReset: return "hold the stylus in the reference posture of the device's manual and calibrate";
    default: return "calibrate it with its maker's program (Touch Setup, Touch Diagnostics)";
  }
}

void HdCalibration::look() noexcept {
  const bool asked = requested_.exchange(false, std::memory_order_relaxed);
  std::uint32_t state = api_->check_calibration();
  const bool offered = state == hd::kNeedsUpdate && !calibrated();
  const std::uint32_t style = asked || offered ? chosenStyle(styles_, asked) : 0u;
  if (style != 0) {
    api_->update_calibration(style);
    state = api_->check_calibration();
  }
  const bool still = calibrated() && state == hd::kNeedsUpdate;
  calibrated_.store(state == hd::kCalibrated || still, std::memory_order_relaxed);
}

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
