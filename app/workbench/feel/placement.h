// One placement of the tube in numbers: time, strokes, forces and depth.
#pragma once

#include <QObject>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "app/editing/edit_history.h"
#include "app/workbench/base/plot_table.h"
#include "app/workbench/feel/procedure.h"
#include "core/haptics/device/device.h"
#include "core/haptics/servo/sample.h"

namespace tactus::workbench {

class EditController;
class FeelController;
class SceneController;

// Keeps how the current state of the model was felt: its strokes, the device and the regions that the tip reached.

/// Thread: gui.
class FeltState : public QObject {
  Q_OBJECT

 public:
  /// Tells `edits` with `setFelt`. The others outlive this.
  FeltState(const FeelController& feel, const SceneController& scene, EditController& edits, QObject* parent = nullptr);

 private:
  struct Kept {
    editing::Felt felt;
    std::set<std::size_t> regions;  ///< indices
  };

  void forget();
  void refreshState();
  void add(std::span<const haptics::Sample> samples);
  void tell();

  const FeelController& feel_;
  const SceneController& scene_;
  EditController& edits_;
  std::map<editing::StateId, Kept> kept_;
  std::vector<DepthRegion> regions_;
  editing::StateId state_ = 0;
  std::uint32_t stroke_ = 0;  ///< the newest one; a stroke counts for the state on which it begins
};

// The last seconds of the samples, reduced enough to be drawn sixty times a second.

/// One point of the force trace; it stands for a few ticks.
struct TracePoint {
  double time_s = 0;                 ///< since the start of the run
  double model_n = 0;                ///< fuzzy force F_d
  double friction_n = 0;             ///< resistance that the friction model asks for
  double force_n = 0;                ///< resistance at the hand, after all limits
  std::optional<double> recorded_n;  ///< force of the replayed recording at this time
};

/// The force of the replayed recording.
struct RecordedForce {
  std::vector<double> time_s;   ///< since the start of the run, ascending
  std::vector<double> force_n;  ///< one per time
};

/// Keeps the last kTraceS seconds. In every kTraceStepS the tick with the largest friction stands for all, so that no
/// peak is lost.
class FeelHistory {
 public:
  static constexpr double kTraceS = 10;
  static constexpr double kTraceStepS = 0.004;

  void clear();
  /// The force to draw beside the next samples, until `clear`.
  void setRecorded(RecordedForce recorded) { recorded_ = std::move(recorded); }
  bool hasRecorded() const { return !recorded_.time_s.empty(); }
  /// Adds a sample. Times must ascend.
  void add(const haptics::Sample& sample);

  const std::deque<TracePoint>& trace() const { return trace_; }
  /// Time from the first to the newest sample, s.
  double nowS() const { return now_s_; }

 private:
  std::optional<double> recordedAt(double time_s) const;

  std::deque<TracePoint> trace_;
  RecordedForce recorded_;
  bool any_ = false;
  std::int64_t start_ns_ = 0;
  double now_s_ = 0;
  std::int64_t step_ = 0;  ///< index of the step of the last point
};

struct PlacementSummary {
  double duration_s = 0;  ///< from the first grip to the last release
  std::uint32_t strokes = 0;
  double peak_force_n = 0;  ///< largest resistance at the hand
  double mean_force_n = 0;  ///< mean resistance while the hand held the tube
  double depth_mm = 0;      ///< greatest depth of the tip
  bool simulated = false;   ///< on a simulated device
  bool replay = false;      ///< a recording moved the tube; no person felt it
};

/// Adds up the samples of one placement.
class PlacementMeter {
 public:
  /// Begins a placement. Samples with orders before `number` belong to the previous one.
  void begin(std::uint64_t number);
  void add(const haptics::Sample& sample, double depth_mm);

  std::uint32_t strokes() const { return strokes_; }
  /// The numbers so far; nothing before the first grip.
  std::optional<PlacementSummary> summary() const;

 private:
  std::uint64_t number_ = 0;
  std::uint32_t strokes_ = 0;
  std::int64_t first_ns_ = 0;
  std::int64_t last_ns_ = 0;
  std::uint64_t ticks_ = 0;  ///< while the hand held the tube
  double sum_n_ = 0;
  double peak_n_ = 0;
  double depth_mm_ = 0;
};

// The force trace of a feel session as a table.

/// Columns: time, s, with the newest sample at 0; felt force, fuzzy force F_d and requested friction force, N; in a
/// replay also the recorded force. The caption names `device` and says if it is simulated.
PlotTable traceTable(const SceneController& scene, const FeelHistory& history,
                     const std::optional<haptics::DeviceInfo>& device);

}  // namespace tactus::workbench
