// Feeling the open model: puts it under the hand on a device, updates it after every edit, and reports what is felt.
// The life of the device itself is a DeviceSession, which other features may use too: their runs are none of this.
// A run is the time from a start of a device to its stop. A placement is one insertion of the tube within a run:
//   run 1: placement 1 (3 strokes), placement 2 (2 strokes)
//   run 2: placement 1 ...
#pragma once

#include <QObject>
#include <QString>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "app/workbench/device/device_session.h"
#include "app/workbench/feel/placement.h"
#include "app/workbench/model/open_model.h"
#include "core/haptics/servo/sample.h"

namespace tactus::workbench {

/// What one force of a model costs: measured once for each shape of a model, because an edit of a number hardly changes
/// it.
class ForceCost {
 public:
  /// The cost of one force of `open`, s (haptics::measuredCostS). Measured if the shape differs from the last time.
  double of(const OpenModel& open);
  /// How often it was measured.
  int measurements() const { return measurements_; }

 private:
  /// What decides how long an evaluation takes: the numbers of experts, rules and terms with their shapes; and the
  /// terms of the output, because a force is computed faster where they have an order.
  struct Shape {
    std::vector<std::size_t> numbers;
    std::vector<double> output_points;

    bool operator==(const Shape&) const = default;
  };
  static Shape shapeOf(const fuzzy::ForceModel& model);

  Shape shape_;
  double cost_s_ = 0;
  int measurements_ = 0;
};

// The time from an edit to its force.

/// In ticks of the servo.
struct EditLatency {
  std::uint64_t last_ticks = 0;     ///< from the edit to the first tick that used it, including the making of the scene
  std::uint64_t longest_ticks = 0;  ///< of all edits of this run
};

/// Finds the first samples that used the orders of each edit.
class FeelLatency {
 public:
  /// An edit was posted with the orders `number`. Its processing began after `ticks_before` ticks.
  void posted(std::uint64_t number, std::uint64_t ticks_before) { pending_.push_back({number, ticks_before}); }
  void onSample(const haptics::Sample& sample);
  /// Nothing before the first edit.
  const std::optional<EditLatency>& value() const { return value_; }

 private:
  struct Pending {
    std::uint64_t number = 0;
    std::uint64_t ticks_before = 0;
  };
  std::deque<Pending> pending_;  ///< posted and not yet seen in a sample
  std::optional<EditLatency> value_;
};

class SceneController;

/// Thread: gui.
class FeelController : public QObject {
  Q_OBJECT

 public:
  using State = DeviceSession::State;

  /// Reads the model and its conditions from `scene`. Moves the scene's depth and speed with the hand.
  FeelController(SceneController& scene, DeviceSession& session, QObject* parent = nullptr);
  /// Ends a run in progress.
  ~FeelController() override;

  /// The device that the model is felt on: its grip, its trip and its advice.
  DeviceSession& session() { return session_; }
  const DeviceSession& session() const { return session_; }
  /// Stopped during the run of another feature.
  State state() const { return isOwnRun() ? session_.state() : State::kStopped; }
  bool isRunning() const { return isOwnRun() && session_.isRunning(); }
  /// Whether the current run replays a recording.
  bool isReplay() const { return isOwnRun() && session_.isReplay(); }
  /// The device of the current run; nothing while stopped.
  std::optional<haptics::DeviceInfo> device() const { return isOwnRun() ? session_.device() : std::nullopt; }
  /// The newest sample; after a run, the last sample with force 0.
  const haptics::Sample& latest() const { return session_.latest(); }
  /// The number of runs so far, from 1.
  std::uint64_t runs() const { return session_.runs(); }

  /// Depth of the tip in the coordinates of the model, mm.
  double depthMm() const { return latest().depth_mm + depth_offset_mm_; }
  /// The offset to add to a sample's depth to get that depth, mm.
  double depthOffsetMm() const { return depth_offset_mm_; }
  /// How far the target of a live hand is ahead of the tube's grip, mm.
  double lagMm() const { return session_.targetMm() - (latest().position_mm - latest().stretch_mm); }
  const FeelHistory& history() const { return history_; }
  std::uint32_t strokes() const { return meter_.strokes(); }
  std::optional<PlacementSummary> lastPlacement() const { return last_placement_; }
  /// Nothing before the first edit of this run.
  const std::optional<EditLatency>& editLatency() const { return latency_.value(); }
  /// How often the cost of the model was measured: once for each shape of a model that is felt.
  int costMeasurements() const { return cost_.measurements(); }
  bool followsHand() const { return follows_hand_; }
  /// Nearer to the pose of the last word than to that of the first.
  bool isPosed() const;
  /// The orders that began the current placement. Samples with older orders belong to the previous one.
  std::uint64_t placementOrders() const { return placement_orders_; }

  /// Replays a recording: `device` moves as recorded, and its button is the hand. `recorded` is drawn beside the force.
  /// Ends with `stateChanged` or `failed`. Refused as `start` is.
  void startReplay(std::unique_ptr<haptics::HapticDevice> device, RecordedForce recorded);

 public slots:
  /// Starts on the device `id` of the list of devices. Ends with `stateChanged` or `failed`. A current run is stopped
  /// first. Takes the first pose at first (`restPoseAtFirst`). Refused: no model is open, the servo refuses it, a start
  /// or a stop is in progress, or another feature uses the device.
  void start(const QString& id);
  /// In any state: zero force from the next tick on. Then the servo and the placement end.
  void stop();
  /// The tube was taken out: ends the placement and begins another one.
  void newPlacement();
  /// The same with the tip at `depth_mm` already, in the coordinates of the model.
  void newPlacementAt(double depth_mm);
  /// Gives the patient the pose of the last word, or that of the first (model/shown_procedure.h, posedInput). The force
  /// follows within one second.
  void setPosed(bool posed);
  /// The patient has the pose of the first word when the procedure begins. Does nothing once the pose was set here or
  /// anywhere else: that of the first operating point is for the curves.
  void restPoseAtFirst();
  /// Sets whether the operating point of the scene follows the hand.
  void setFollowsHand(bool follows);

 signals:
  void stateChanged();
  /// New samples arrived. At most 60 times a second, and never while stopped.
  void advanced();
  /// The same samples, complete and oldest first, for recorders. Valid during the call.
  void sampled(std::span<const tactus::haptics::Sample> samples);
  /// The hand moved the tube: depth in the model's coordinates, mm; inward speed of the tube, mm/s.
  void handMoved(double depth_mm, double speed_mm_s);
  void placementEnded();
  void poseChanged();
  /// One sentence: what could not be started or felt, and why.
  void failed(const QString& sentence);

 private:
  /// The place of the tube as the screen shows it.
  struct Shown {
    double depth_mm = 0;
    double speed_mm_s = 0;

    bool operator==(const Shown&) const = default;
  };
  bool prepare();
  void keepPlace();
  void putBack();
  bool isOwnRun() const { return session_.user() == this; }
  void onBegan();
  void onBeating();
  void onSampled(std::span<const haptics::Sample> samples);
  void onAdvanced();
  void onModel();
  void onAnotherModel();
  void onValue(std::size_t input);
  void onHandMoved(double depth_mm);
  void followSpeed();
  bool isFelt() const { return isRunning() || state() == State::kOpening; }
  Shown shown() const;
  base::Result<std::shared_ptr<const haptics::ServoScene>> servoScene(double fade_s);
  bool postScene(double fade_s);
  void endPlacement();

  SceneController& scene_;
  DeviceSession& session_;
  ForceOrders force_;           ///< the last posted ones
  double depth_offset_mm_ = 0;  ///< of the last posted scene
  FeelHistory history_;
  RecordedForce recorded_;  ///< of a replay that is about to begin
  Shown shown_before_;      ///< at the beginning of a beat
  bool follows_hand_ = true;
  double followed_mm_s_ = 0;      ///< the speed of the hand, smoothed for the curves
  std::int64_t followed_ns_ = 0;  ///< time of the sample that it follows
  bool resting_ = false;          ///< the procedure sets the pose, not the user
  bool posing_ = false;           ///< the next change of the pose is a gesture
  bool pose_set_ = false;
  /// What the hand and the procedure move while the model is felt, as it was before; put back when the run has stopped.
  struct Before {
    std::map<std::size_t, double> values;  ///< by input
    bool pose_set = false;
  };
  std::optional<Before> before_;
  bool conditions_new_ = false;  ///< posted at the next beat, because a dragged slider changes them more often
  std::uint64_t placement_orders_ = 0;
  PlacementMeter meter_;
  std::optional<PlacementSummary> last_placement_;
  FeelLatency latency_;
  ForceCost cost_;
};

}  // namespace tactus::workbench
