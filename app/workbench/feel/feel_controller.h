// Feeling the open model: runs the servo on a device, keeps it up to date with every edit, and tells what is felt.
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
#include <string>

#include "app/devices/open_device.h"
#include "app/workbench/feel/feel_grip.h"
#include "app/workbench/feel/feel_history.h"
#include "app/workbench/feel/feel_latency.h"
#include "app/workbench/feel/feel_loop.h"
#include "app/workbench/feel/placement.h"
#include "core/haptics/device/device.h"
#include "core/haptics/safety/thermal_ledger.h"
#include "core/haptics/safety/trip.h"
#include "core/haptics/servo/loop_statistics.h"
#include "core/haptics/servo/loop_watch.h"
#include "core/haptics/servo/sample.h"

namespace tactus::workbench {

class FeelRun;
class SceneController;

enum class FeelState {
  kStopped,   ///< no servo, nothing is computed
  kOpening,   ///< a device takes its time to start; no force yet
  kRunning,   ///< forces are possible
  kTripped,   ///< zero force until somebody arms again
  kRearming,  ///< waits for the hand to let go
  kStopping,  ///< no force any more; a device takes its time to stop
};

/// What ended the force, for the screen.
struct FeelTrip {
  QString sentence;  ///< cause, and value and limit once they are known
  QTime at;          ///< time of day
};

/// Where devices and loops come from; a test gives its own.
struct FeelSettings {
  std::function<base::Result<devices::OpenedDevice>(const std::string& id)> open_device;
  MakeFeelLoop make_loop;
  /// Whether the device `id` may take its time to start and to stop. It then does so in the background, and the window
  /// stays alive. Without it no device does.
  std::function<bool(const std::string& id)> is_slow;
  /// What the motors of each device have given, from one run to the next. Never null.
  std::shared_ptr<haptics::ThermalLedger> thermal = std::make_shared<haptics::ThermalLedger>();
};
/// Devices of this computer under a thread of their own.
FeelSettings realFeel();

/// Thread: gui. Only FeelRun's servo has another thread.
class FeelController : public QObject {
  Q_OBJECT

 public:
  /// Reads the model and its conditions from `scene`, and moves its depth and speed with the hand.
  explicit FeelController(SceneController& scene, FeelSettings settings = realFeel(), QObject* parent = nullptr);
  ~FeelController() override;

  FeelState state() const { return state_; }
  bool isRunning() const { return run_ != nullptr; }
  /// What runs is the replay of a recording.
  bool isReplay() const { return run_ && replay_; }
  /// What is felt on; nothing while stopped.
  std::optional<haptics::DeviceInfo> device() const;
  /// The hand is one that mouse and keyboard drive.
  bool isHandLive() const;
  const FeelGrip& grip() const { return grip_; }
  /// What to do where inwards turns out to be outwards; empty for a device with one axis.
  QString axisAdvice() const;
  QString priorityText() const;
  std::optional<FeelTrip> trip() const { return trip_; }

  /// The newest sample; of a run that has ended, without force.
  const haptics::Sample& latest() const { return latest_; }
  /// Depth of the tip as the model counts it, mm.
  double depthMm() const;
  /// What has to be added to the depth of a sample for that.
  double depthOffsetMm() const { return depth_offset_mm_; }
  /// How far the wish of a live hand is ahead of the tube's grip, mm.
  double lagMm() const { return target_mm_ - (latest_.position_mm - latest_.stretch_mm); }
  double targetMm() const { return target_mm_; }
  const FeelHistory& history() const { return history_; }
  std::uint32_t strokes() const { return meter_.strokes(); }
  std::optional<PlacementSummary> lastPlacement() const { return last_placement_; }
  /// Nothing before the first edit of this run.
  const std::optional<EditLatency>& editLatency() const { return latency_.value(); }
  /// Of the present run; empty while stopped.
  haptics::LoopStatistics statistics() const;
  bool followsHand() const { return follows_hand_; }
  bool isNeckFlexed() const;
  /// Counts the runs, from 1.
  std::uint64_t runs() const { return runs_; }
  /// Samples from before these orders belong to the placement before.
  std::uint64_t placementOrders() const { return placement_orders_; }

  /// Starts on `device`, which moves by itself as a recording did, with its button as the hand; `recorded` stands
  /// beside the force. Ends with `stateChanged` or `failed`. A model must be open, and nothing opening or stopping.
  void startReplay(std::unique_ptr<haptics::HapticDevice> device, RecordedForce recorded);

 public slots:
  /// Starts on the device `id` of the list of devices; ends with `stateChanged` or `failed`. A model must be open, and
  /// nothing running, opening or stopping.
  void start(const QString& id);
  /// No force from the next tick on, in any state; then the servo ends, and the placement with it.
  void stop();
  void setGrip(const tactus::workbench::FeelGrip& grip);
  /// After a trip: disarms, waits until the hand lets go, and arms.
  void rearm();
  /// The tube is taken out: the placement ends and another one begins.
  void newPlacement();
  /// Pedal, key or mouse button that holds the tube.
  void setHeld(bool held);
  /// Where a live hand wants to be along its axis, mm.
  void setTarget(double position_mm);
  /// Asks the patient to flex the neck or to hold the head upright; the force follows within a second.
  void setNeckFlexed(bool flexed);
  /// Whether the operating point of the scene follows the hand.
  void setFollowsHand(bool follows);
  /// What has happened since the last time; called 60 times a second while running.
  void beat();

 signals:
  void stateChanged();
  /// New samples; at most 60 times a second, and never while stopped.
  void advanced();
  void tripChanged();
  /// The same samples, oldest first, every one of them; for who keeps them. Valid during the call.
  void sampled(std::span<const tactus::haptics::Sample> samples);
  /// The hand moved the tube: depth in mm of the model, speed of the tube inwards in mm/s.
  void handMoved(double depth_mm, double speed_mm_s);
  void placementEnded();
  void neckChanged();
  /// One sentence: what could not be started or felt, and why.
  void failed(const QString& sentence);

 private:
  /// A run that is to begin.
  struct Beginning {
    std::function<base::Result<devices::OpenedDevice>()> open;
    bool slow = false;  ///< in the background
    bool replay = false;
    RecordedForce recorded;  ///< of a replay
  };
  void startOn(Beginning beginning);
  void takeAll(std::span<const haptics::Sample> samples);
  void onModel();
  void onAnotherModel();
  void onValue(std::size_t input);
  void onHandMoved(double depth_mm, double speed_mm_s);
  bool postScene(double fade_s);
  void take(const haptics::Sample& sample);
  void watchTrip();
  bool watchLoop();
  void watchRelease();
  void endPlacement();
  void enter(FeelState state);
  void begin(base::Result<std::unique_ptr<FeelRun>> run, bool replay, RecordedForce recorded);
  void endInBackground(std::unique_ptr<FeelRun> run);
  void lookAtDevice();

  SceneController& scene_;
  const FeelSettings settings_;
  QTimer beat_;
  std::unique_ptr<FeelRun> run_;
  bool slow_ = false;  ///< the device of the present run stops in the background
  // A device that starts or stops in the background; their destructors wait for it.
  std::future<base::Result<std::unique_ptr<FeelRun>>> opening_;
  std::future<void> ending_;
  QTimer look_;
  FeelGrip grip_;
  FeelState state_ = FeelState::kStopped;
  haptics::Sample latest_;
  double depth_offset_mm_ = 0;  ///< of the scene that was posted last
  FeelHistory history_;
  std::optional<FeelTrip> trip_;
  double target_mm_ = 0;
  bool held_ = false;
  bool follows_hand_ = true;
  bool flexing_ = false;         ///< the change of neck flexion that is coming is a gesture
  bool conditions_new_ = false;  ///< posted at the next beat: a slider that is dragged changes them more often
  std::uint64_t placements_ = 0;
  std::uint64_t placement_orders_ = 0;
  std::uint64_t runs_ = 0;
  bool replay_ = false;
  PlacementMeter meter_;
  std::optional<PlacementSummary> last_placement_;

  haptics::LoopWatch loop_watch_;
  FeelLatency latency_;
  std::uint64_t arming_ = 0;  ///< number of the orders that disarm, while re-arming; then of those that arm
};

}  // namespace tactus::workbench
