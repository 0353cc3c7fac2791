#include "app/workbench/device/device_session.h"

#include <QString>
#include <chrono>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/devices/device_list.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/device/device_search.h"
#include "core/base/error.h"
#include "core/haptics/safety/safety.h"
#include "core/haptics/servo/servo.h"
#include "core/haptics/simulated/virtual_device.h"

namespace tactus::haptics {
class VirtualDevice;
}  // namespace tactus::haptics

namespace tactus::workbench {

// One run of a device: open, started, and driven by the servo.

/// The run lasts from `begin` to the destructor, which leaves the device with zero force. Thread: one at a time. A slow
/// device begins and ends on a background thread.
class DeviceRun {
 public:
  /// Starts the device, and a servo on it with `orders`, the axis of the device and limits that fit it. Sends the first
  /// heartbeat of the program. `thermal` may be null; otherwise it holds the motor heat of earlier runs. Refused: the
  /// device or the loop does not start.
  static base::Result<std::unique_ptr<DeviceRun>> begin(devices::OpenedDevice opened, const MakeServoLoop& make_loop,
                                                        haptics::ServoOrders orders,
                                                        std::shared_ptr<haptics::ThermalLedger> thermal = nullptr);
  ~DeviceRun();
  DeviceRun(const DeviceRun&) = delete;
  DeviceRun& operator=(const DeviceRun&) = delete;

  haptics::Servo& servo() { return *servo_; }
  const haptics::DeviceInfo& info() const { return device_->info(); }
  const ServoLoop& loop() const { return *loop_; }
  /// The last posted orders. The owner changes them and posts them again.
  haptics::ServoOrders& orders() { return orders_; }
  /// Posts the orders; returns their number.
  std::uint64_t post();
  void heartbeat() { servo_->heartbeat(loop_->nowNs()); }
  /// The samples since the last call, oldest first. Valid until the next call.
  std::span<const haptics::Sample> drain();
  /// The device if mouse and keyboard drive its hand; otherwise null.
  haptics::VirtualDevice* liveHand() const { return live_hand_; }
  /// What to do if the device reports that it is not calibrated.
  const std::string& calibrationAdvice() const { return calibration_advice_; }
  /// What to do if inward and outward are swapped; may be empty.
  const std::string& axisAdvice() const { return axis_advice_; }
  /// Zero force from the next tick on; then no more ticks. May be called twice.
  void end() noexcept;

 private:
  DeviceRun(devices::OpenedDevice opened, const MakeServoLoop& make_loop, haptics::ServoOrders orders,
            std::shared_ptr<haptics::ThermalLedger> thermal);

  // In this order, so that the loop is destroyed before the servo, and the servo before the device.
  std::shared_ptr<haptics::ThermalLedger> thermal_;
  std::unique_ptr<haptics::HapticDevice> device_;
  haptics::VirtualDevice* live_hand_;
  std::string calibration_advice_;
  std::string axis_advice_;
  haptics::ServoOrders orders_;
  std::unique_ptr<haptics::Servo> servo_;
  std::unique_ptr<ServoLoop> loop_;
  std::vector<haptics::Sample> drained_;
};

namespace {

/// More than the ticks between two looks at 60 Hz, with room for a pause of the program.
constexpr std::size_t kMostDrained = 16'384;

}  // namespace

base::Result<std::unique_ptr<DeviceRun>> DeviceRun::begin(devices::OpenedDevice opened, const MakeServoLoop& make_loop,
                                                          haptics::ServoOrders orders,
                                                          std::shared_ptr<haptics::ThermalLedger> thermal) {
  if (auto started = opened.device->start(); !started) return tl::unexpected(started.error());
  // Not make_unique: the constructor is private, so that no run exists whose device has not been started.
  std::unique_ptr<DeviceRun> run(new DeviceRun(std::move(opened), make_loop, std::move(orders), std::move(thermal)));
  run->post();
  run->heartbeat();
  if (auto started = run->loop_->start(); !started) return tl::unexpected(started.error());
  return run;
}

DeviceRun::DeviceRun(devices::OpenedDevice opened, const MakeServoLoop& make_loop, haptics::ServoOrders orders,
                     std::shared_ptr<haptics::ThermalLedger> thermal)
    : thermal_(std::move(thermal)),
      device_(std::move(opened.device)),
      live_hand_(dynamic_cast<haptics::VirtualDevice*>(device_.get())),
      calibration_advice_(std::move(opened.calibration_advice)),
      axis_advice_(std::move(opened.axis_advice)),
      orders_(std::move(orders)),
      servo_(std::make_unique<haptics::Servo>(*device_, thermal_.get())),
      loop_(make_loop(*servo_)),
      drained_(kMostDrained) {
  orders_.axis = opened.axis;
  const bool guard_velocity = orders_.limits.guard_velocity;
  orders_.limits = haptics::LimitSettings::forDevice(device_->info());
  orders_.limits.guard_velocity = guard_velocity;
}

DeviceRun::~DeviceRun() { end(); }

std::uint64_t DeviceRun::post() { return servo_->post(orders_); }

std::span<const haptics::Sample> DeviceRun::drain() { return servo_->drain(drained_); }

void DeviceRun::end() noexcept {
  servo_->stop();
  loop_->stop();
  device_->stop();
}

using haptics::EnableKind;

bool isHeldByKey(const haptics::DeviceInfo& device) { return device.backend == "virtual" || device.buttons == 0; }

haptics::EnableSettings enableOf(const haptics::DeviceInfo& device, const DeviceGrip& grip) {
  haptics::EnableSettings enable;
  enable.kind = grip.latch ? EnableKind::kLatch : isHeldByKey(device) ? EnableKind::kPedal : EnableKind::kButton;
  enable.release_zone_mm = grip.release_zone_mm;
  return enable;
}

haptics::EnableSettings enableOfReplay() {
  haptics::EnableSettings enable;
  enable.kind = EnableKind::kButton;
  // What was recorded is the hand after its debounce.
  enable.press_debounce_s = 0;
  return enable;
}

bool isDown(const haptics::EnableSettings& enable, const haptics::Sample& sample, bool key_down) {
  const bool button = (sample.buttons & enable.button_mask) != 0;
  switch (enable.kind) {
    case EnableKind::kPedal:
    case EnableKind::kKey: return key_down;
    case EnableKind::kLatch: return key_down || button;
    case EnableKind::kButton: break;
  }
  return button;
}

namespace {

constexpr int kBeatMs = 16;  // the refresh of a screen
constexpr int kLookMs = 30;  // while a device starts or stops

QString sentenceCase(QString sentence) {
  if (!sentence.isEmpty()) sentence[0] = sentence[0].toUpper();
  return sentence;
}

void addTo(haptics::ServoOrders& orders, ForceOrders force) {
  orders.source = force.source;
  orders.scene = std::move(force.scene);
  orders.placement = force.placement;
  orders.start_depth_mm = force.start_depth_mm;
  // Without force a fast hand is no danger: the speed experiment asks for it.
  orders.limits.guard_velocity = force.source != haptics::ForceSource::kFree;
  orders.stimulus = force.stimulus;
  orders.scale = force.scale;
}

}  // namespace

DeviceSession::DeviceSession(DeviceAccess access, QObject* parent) : QObject(parent), access_(std::move(access)) {
  beat_.setInterval(kBeatMs);
  beat_.setTimerType(Qt::PreciseTimer);
  look_.setInterval(kLookMs);
  connect(&beat_, &QTimer::timeout, this, &DeviceSession::beat);
  connect(&look_, &QTimer::timeout, this, &DeviceSession::lookAtDevice);
}

DeviceSession::~DeviceSession() = default;

std::optional<haptics::DeviceInfo> DeviceSession::device() const {
  if (!run_) return std::nullopt;
  return run_->info();
}

bool DeviceSession::isHandLive() const { return run_ && run_->liveHand() != nullptr; }

QString DeviceSession::axisAdvice() const {
  return run_ && run_->info().position_axes > 1 ? text(run_->axisAdvice()) : QString();
}

QString DeviceSession::priorityText() const { return run_ ? run_->loop().priorityText() : QString(); }

haptics::LoopStatistics DeviceSession::statistics() const {
  return run_ ? run_->servo().statistics() : haptics::LoopStatistics{};
}

std::uint64_t DeviceSession::ticks() const { return run_ ? run_->servo().ticks() : 0; }

void DeviceSession::start(const QString& id, ForceOrders force, const QObject* user) {
  const std::string device = id.toStdString();
  startOn({[open_device = access_.open_device, device] { return open_device(device); },
           access_.is_slow && access_.is_slow(device), false},
          std::move(force), user);
}

void DeviceSession::startReplay(std::unique_ptr<haptics::HapticDevice> device, ForceOrders force, const QObject* user) {
  // A function can be copied, a device cannot.
  const auto opened = std::make_shared<devices::OpenedDevice>();
  opened->device = std::move(device);
  startOn({[opened]() -> base::Result<devices::OpenedDevice> { return std::move(*opened); }, false, true},
          std::move(force), user);
}

void DeviceSession::startOn(Beginning beginning, ForceOrders force, const QObject* user) {
  if (run_) stop();
  if (state_ != State::kStopped) {
    emit failed(tr("The device before is still starting or stopping; try again when it has stopped."));
    return;
  }
  user_ = user;
  force_ = std::move(force);
  haptics::ServoOrders orders;
  addTo(orders, force_);
  orders.armed = true;
  slow_ = beginning.slow;
  const auto open =
      [open_device = beginning.open, make_loop = access_.make_loop, grip = grip_, replay = beginning.replay,
       thermal = access_.thermal](haptics::ServoOrders given) -> base::Result<std::unique_ptr<DeviceRun>> {
    TACTUS_TRY(auto opened, open_device());
    given.enable = replay ? enableOfReplay() : enableOf(opened.device->info(), grip);
    return DeviceRun::begin(std::move(opened), make_loop, std::move(given), thermal);
  };
  if (!slow_) {
    begin(open(std::move(orders)), beginning.replay);
    return;
  }
  opening_ = std::async(std::launch::async, open, std::move(orders));
  enter(State::kOpening);
  look_.start();
}

void DeviceSession::begin(base::Result<std::unique_ptr<DeviceRun>> run, bool replay) {
  if (!run) {
    if (state_ != State::kStopped) enter(State::kStopped);
    emit failed(text(run.error().message()));
    return;
  }
  run_ = std::move(*run);
  replay_ = replay;
  ++runs_;
  latest_ = {};
  loop_watch_ = {};
  thermal_ = haptics::ThermalFollower(access_.thermal->of(run_->info().id));
  trip_.reset();
  held_ = press_due_ = release_due_ = false;
  target_mm_ = 0;
  arming_ = 0;
  if (state_ == State::kOpening) {
    // What changed while the device started.
    run_->orders().enable = enableOf(run_->info(), grip_);
    addTo(run_->orders(), force_);
    run_->post();
  }
  beat_.start();
  emit began();
  emit tripChanged();
  enter(State::kRunning);
}

std::optional<std::uint64_t> DeviceSession::setForce(ForceOrders force) {
  force_ = std::move(force);
  if (!run_) return std::nullopt;
  addTo(run_->orders(), force_);
  return run_->post();
}

void DeviceSession::stop() {
  if (state_ == State::kOpening) {
    // It is ended as soon as it has started; its first orders are armed, but no hand has taken the tube.
    enter(State::kStopping);
    return;
  }
  if (!run_) return;
  beat_.stop();
  run_->servo().stop();
  if (!slow_) run_->end();
  onSamples(run_->drain());
  emit ending();
  if (slow_) {
    endInBackground(std::move(run_));
    look_.start();
  }
  run_.reset();
  latest_.force_n = latest_.source_force_n = latest_.model_force_n = latest_.stretch_mm = 0;
  latest_.phase = render::Phase::kReleased;
  latest_.enabled = false;
  held_ = press_due_ = release_due_ = false;
  enter(slow_ ? State::kStopping : State::kStopped);
}

void DeviceSession::endInBackground(std::unique_ptr<DeviceRun> run) {
  // Its destructor stops loop and device.
  ending_ = std::async(
      std::launch::async, [](std::unique_ptr<DeviceRun> last) { last.reset(); }, std::move(run));
}

void DeviceSession::lookAtDevice() {
  const auto ready = [](const auto& future) {
    return future.valid() && future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  };
  if (ready(opening_)) {
    auto run = opening_.get();
    if (state_ == State::kOpening) {
      look_.stop();
      begin(std::move(run), false);
    } else if (run) {
      endInBackground(std::move(*run));
    } else {
      look_.stop();
      enter(State::kStopped);
    }
  } else if (ready(ending_)) {
    look_.stop();
    ending_.get();
    enter(State::kStopped);
  }
}

void DeviceSession::setGrip(const DeviceGrip& grip) {
  if (grip == grip_) return;
  grip_ = grip;
  setHeld(false);
  if (run_ && !replay_) {
    run_->orders().enable = enableOf(run_->info(), grip_);
    run_->post();
  }
  emit stateChanged();
}

void DeviceSession::rearm() {
  if (state_ != State::kTripped) return;
  run_->orders().armed = false;
  arming_ = run_->post();
  enter(State::kRearming);
}

void DeviceSession::setHeld(bool held) {
  held_ = held && run_ != nullptr;
  if (!run_) return;
  if (held_) {
    press_due_ = true;
    pressed_ns_.reset();
  } else if (grip_.latch && press_due_) {
    release_due_ = true;
    return;
  }
  release_due_ = false;
  run_->servo().pedal(held_);
}

// A switch bounces, so the servo takes a press after a time that a click of the mouse may not last.
void DeviceSession::followTap(const haptics::Sample& sample) {
  if (!pressed_ns_) pressed_ns_ = sample.time_ns;
  const double down_s = static_cast<double>(sample.time_ns - *pressed_ns_) * 1e-9;
  if (down_s < 2 * run_->orders().enable.press_debounce_s) return;
  press_due_ = false;
  if (std::exchange(release_due_, false)) run_->servo().pedal(false);
}

void DeviceSession::setTarget(double position_mm) {
  target_mm_ = position_mm;
  if (isHandLive()) run_->liveHand()->setTarget(position_mm);
}

void DeviceSession::beat() {
  if (!run_) return;
  run_->heartbeat();
  emit beating();
  if (!run_) return;
  const auto samples = run_->drain();
  const bool any = !samples.empty();
  onSamples(samples);
  if (!run_ || !watchLoop()) return;
  watchTrip();
  watchRelease();
  if (any) emit advanced();
}

haptics::LimitSettings DeviceSession::limits() const { return run_ ? run_->orders().limits : haptics::LimitSettings(); }

void DeviceSession::onSamples(std::span<const haptics::Sample> samples) {
  for (const haptics::Sample& sample : samples) thermal_.add(sample, run_->orders().limits);
  if (samples.empty()) return;
  latest_ = samples.back();
  if (press_due_) followTap(latest_);
  emit sampled(samples);
}

/// A servo that is not called cannot trip, and nothing that is asked for arrives: false ends the run.
bool DeviceSession::watchLoop() {
  const haptics::Trip silent = loop_watch_.look(run_->servo().ticks(), run_->loop().nowNs());
  if (!silent) return true;
  stop();
  emit failed(
      tr("The loop of the device's driver has ended: %1. Look at cable and supply of the device, then start again.")
          .arg(text(haptics::sentence(silent))));
  return false;
}

void DeviceSession::watchTrip() {
  // A sample from before the arming still tells of the trip that it cleared.
  const bool armed = state_ == State::kRunning && latest_.orders >= arming_;
  if (armed && latest_.trip != haptics::TripCause::kNone) {
    const std::string_view cause = haptics::describe(latest_.trip);
    trip_ = DeviceTrip{sentenceCase(text(std::string(cause))), QTime::currentTime()};
    enter(State::kTripped);
    emit tripChanged();
  }
  if (!run_) return;
  // The record of the trip, which knows value and limit, is complete 0.2 s after it.
  if (const auto record = run_->servo().takeFlightRecord(); record && trip_) {
    trip_->sentence = sentenceCase(text(haptics::sentence(record->trip)));
    const bool uncalibrated = record->trip.cause == haptics::TripCause::kDeviceFault &&
                              record->trip.value == static_cast<double>(haptics::DeviceFault::kNotCalibrated);
    if (uncalibrated) trip_->sentence += QStringLiteral("; ") + text(run_->calibrationAdvice());
    emit tripChanged();
  }
}

void DeviceSession::watchRelease() {
  if (!run_ || state_ != State::kRearming || latest_.orders < arming_) return;
  if (isDown(run_->orders().enable, latest_, held_)) return;
  run_->orders().armed = true;
  arming_ = run_->post();
  trip_.reset();
  emit tripChanged();
  enter(State::kRunning);
}

void DeviceSession::enter(State state) {
  state_ = state;
  emit stateChanged();
}

}  // namespace tactus::workbench
