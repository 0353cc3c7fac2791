// The life of one haptic device, for any source of force: start, samples, trip, re-arm and stop. It needs no model: a
// feature says with ForceOrders where the force comes from. DeviceSearch finds the devices.
// A run is the time from a start of a device to its stop.
#pragma once

#include <QObject>
#include <QString>
#include <QTime>
#include <QTimer>
#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <span>

#include "app/workbench/device/device_search.h"
#include "core/haptics/device/device.h"
#include "core/haptics/safety/limit_settings.h"
#include "core/haptics/safety/thermal_budget.h"
#include "core/haptics/servo/loop_statistics.h"
#include "core/haptics/servo/sample.h"
#include "core/haptics/sources/force_source.h"
#include "core/haptics/sources/servo_scene.h"

namespace tactus::workbench {

// How the hand holds and releases the tube: the user's choice, and the settings for the servo.

/// The device's own switch, or a latch. The latch is useful because a squeezed switch changes the feel.
struct DeviceGrip {
  bool latch = false;            ///< a first press holds the tube, a second one releases it
  double release_zone_mm = -20;  ///< with a latch: axis positions further out also release it

  bool operator==(const DeviceGrip&) const = default;
};

/// Whether a key or the mouse holds the tube, because the device has no button.
bool isHeldByKey(const haptics::DeviceInfo& device);

haptics::EnableSettings enableOf(const haptics::DeviceInfo& device, const DeviceGrip& grip);
/// The settings for a replay: the recorded hand is the button of the replaying device.
haptics::EnableSettings enableOfReplay();

/// Whether the switch is down: in `sample`, or, for a switch of the program, as `key_down` says.
bool isDown(const haptics::EnableSettings& enable, const haptics::Sample& sample, bool key_down);

class DeviceRun;

/// Where the force comes from. The session adds what belongs to the device: axis, limits, grip and arming.
struct ForceOrders {
  haptics::ForceSource source = haptics::ForceSource::kFree;
  std::shared_ptr<const haptics::ServoScene> scene;  ///< for kInsertion
  std::uint64_t placement = 0;                       ///< for kInsertion: another number begins another placement
  double start_depth_mm = 0;                         ///< for kInsertion: of the tube when a placement begins
  haptics::Stimulus stimulus;                        ///< for kStimulus: another number begins another stimulus
  double scale = 1;  ///< the hand gets the force divided by it (Procedure::device_scale)
};

/// The cause of a trip, for the screen.
struct DeviceTrip {
  QString sentence;  ///< the cause, with value and limit if known
  QTime at;          ///< time of day
};

/// Thread: gui. Only the servo of DeviceRun runs on another thread.
class DeviceSession : public QObject {
  Q_OBJECT

 public:
  enum class State {
    kStopped,   ///< no servo, nothing is computed
    kOpening,   ///< a slow device is starting; no force yet
    kRunning,   ///< the servo runs; forces are possible
    kTripped,   ///< zero force until the user arms it again
    kRearming,  ///< armed again as soon as the hand lets go
    kStopping,  ///< zero force; a slow device is stopping
  };

  explicit DeviceSession(DeviceAccess access = realDevices(), QObject* parent = nullptr);
  /// Ends the run; waits for a device that is still starting or stopping.
  ~DeviceSession() override;

  State state() const { return state_; }
  /// Whether there is a run: running, tripped or re-arming.
  bool isRunning() const { return run_ != nullptr; }
  /// Whether the device of the current run moves by itself, as a recording did.
  bool isReplay() const { return run_ && replay_; }
  /// The device of the current run; nothing while stopped.
  std::optional<haptics::DeviceInfo> device() const;
  /// Whether mouse and keyboard drive the hand.
  bool isHandLive() const;
  const DeviceGrip& grip() const { return grip_; }
  /// What to do if inward and outward are swapped; empty for a device with one axis.
  QString axisAdvice() const;
  QString priorityText() const;
  /// The trip of the current or the last run, until it is armed again or the next run starts.
  const std::optional<DeviceTrip>& trip() const { return trip_; }

  /// The newest sample; after a run, the last sample with force 0.
  const haptics::Sample& latest() const { return latest_; }
  /// The target of a live hand along its axis, mm.
  double targetMm() const { return target_mm_; }
  /// Of the current run; empty while stopped.
  haptics::LoopStatistics statistics() const;
  /// Ticks of the current run so far; 0 while stopped.
  std::uint64_t ticks() const;
  /// The number of runs so far, from 1.
  std::uint64_t runs() const { return runs_; }

  /// A number that no stimulus and no placement of this session had before.
  std::uint64_t newNumber() { return ++numbers_; }
  /// The heat of the motors of the current run at its newest sample: how long they must rest before a force.
  const haptics::ThermalBudget& thermal() const { return thermal_.budget(); }
  /// Of the current run; the defaults while stopped.
  haptics::LimitSettings limits() const;

  /// Starts on the device `id` of the list of devices. Ends with `stateChanged` or `failed`. A current run is stopped
  /// first. Refused: a start or a stop is in progress. `user`: who gives the force during this run.
  void start(const QString& id, ForceOrders force = {}, const QObject* user = nullptr);
  /// The same on `device`, which moves by itself as a recording did; its button is the hand.
  void startReplay(std::unique_ptr<haptics::HapticDevice> device, ForceOrders force, const QObject* user = nullptr);
  /// Who started the current or the last run. Several features share one device: each ignores the runs of the others.
  const QObject* user() const { return user_; }
  /// Changes where the force comes from; in force from the next tick on. Returns the number of these orders, as samples
  /// carry it. Nothing while no run is in progress: a device that is starting then begins with them.
  std::optional<std::uint64_t> setForce(ForceOrders force);

 public slots:
  /// In any state: zero force from the next tick on. Then the run ends.
  void stop();
  void setGrip(const tactus::workbench::DeviceGrip& grip);
  /// Arms again after a trip: disarms, waits until the hand lets go, and arms.
  void rearm();
  /// Sets the state of the pedal, key or mouse button that holds the tube. With a latch a press of any length counts:
  /// one that ends before the servo takes it is held for it.
  void setHeld(bool held);
  /// Sets the target position of a live hand along its axis, mm.
  void setTarget(double position_mm);
  /// Processes the new samples. Called 60 times a second during a run.
  void beat();

 signals:
  void stateChanged();
  void tripChanged();
  /// A run has begun, and `stateChanged` is about to say so: time to forget the previous run.
  void began();
  /// A beat is about to read the new samples: the last chance to change the orders before it.
  void beating();
  /// All samples since the last time, oldest first. Valid during the call.
  void sampled(std::span<const tactus::haptics::Sample> samples);
  /// A beat has processed new samples. At most 60 times a second, and never while stopped.
  void advanced();
  /// The run is about to end: there is no more force, and all samples were sent.
  void ending();
  /// One sentence: what could not be started, or why the run ended.
  void failed(const QString& sentence);

 private:
  /// The parameters of a run that is about to begin.
  struct Beginning {
    std::function<base::Result<devices::OpenedDevice>()> open;
    bool slow = false;  ///< starts in the background
    bool replay = false;
  };
  void startOn(Beginning beginning, ForceOrders force, const QObject* user);
  void begin(base::Result<std::unique_ptr<DeviceRun>> run, bool replay);
  void endInBackground(std::unique_ptr<DeviceRun> run);
  void lookAtDevice();
  void onSamples(std::span<const haptics::Sample> samples);
  void followTap(const haptics::Sample& sample);
  bool watchLoop();
  void watchTrip();
  void watchRelease();
  void enter(State state);

  const DeviceAccess access_;
  QTimer beat_;
  std::unique_ptr<DeviceRun> run_;
  bool slow_ = false;  ///< the device of the current run stops in the background
  // Devices that start or stop in the background. The destructors of these futures wait for them.
  std::future<base::Result<std::unique_ptr<DeviceRun>>> opening_;
  std::future<void> ending_;
  QTimer look_;

  State state_ = State::kStopped;
  const QObject* user_ = nullptr;  ///< only compared
  ForceOrders force_;
  DeviceGrip grip_;
  haptics::Sample latest_;
  std::optional<DeviceTrip> trip_;
  double target_mm_ = 0;
  bool held_ = false;
  std::optional<std::int64_t> pressed_ns_;  ///< time of the first sample with the current press
  bool press_due_ = false;                  ///< pressed, and no sample has come since
  bool release_due_ = false;                ///< let go before the press was taken
  bool replay_ = false;
  std::uint64_t runs_ = 0;
  std::uint64_t arming_ = 0;  ///< while re-arming: number of the orders that disarm, then of the orders that arm
  std::uint64_t numbers_ = std::uint64_t{1} << 32U;  ///< those that are counted by hand are far below
  haptics::LoopWatch loop_watch_;
  haptics::ThermalFollower thermal_;  ///< of the current run
};

}  // namespace tactus::workbench
