// Runs a scenario: the servo's tick on a simulated device, in simulated time.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/simulation/scenario.h"
#include "core/base/error.h"
#include "core/base/tables/csv.h"
#include "core/fuzzy/force_model.h"
#include "core/haptics/servo/sample.h"
#include "core/haptics/servo/servo_core.h"

namespace tactus::simulation {

/// One tick: the servo's sample, and the true state of the simulation.
struct TraceTick {
  haptics::Sample sample;  ///< its time counts from the start of the run
  haptics::HandTarget wish;
  double true_position_mm = 0;
  double true_speed_mm_s = 0;
  double device_force_n = 0;                        ///< resistance of the device, after its delay and limits
  const haptics::Conditions* conditions = nullptr;  ///< valid at this tick; the pointer is valid during the call only
};

struct TripSeen {
  double at_s = 0;
  haptics::Trip trip;
};

/// How often a limit became active, and for how long in total.
struct LimitSeen {
  int times = 0;
  std::uint64_t ticks = 0;  ///< of 1 ms
};

/// The results of a run.
struct RunSummary {
  double duration_s = 0;
  std::uint64_t ticks = 0;
  int strokes = 0;               ///< number of strokes in which the tube slid in
  double start_depth_mm = 0;     ///< initial depth of the tube
  double depth_mm = 0;           ///< final depth of the tube
  double planned_mm = 0;         ///< inward distance that the hand wanted to push with the button down
  double largest_force_n = 0;    ///< against insertion or withdrawal
  double mean_sliding_n = 0;     ///< mean resistance while the tube slid in; 0 if it never did
  double largest_step_n = 0;     ///< largest change of the resistance between two ticks
  int transitions = 0;           ///< between stuck and sliding
  std::uint64_t held_ticks = 0;  ///< ticks without a firing rule, in which the last force was held
  render::SceneCounters scene;
  std::vector<TripSeen> trips;
  std::array<LimitSeen, haptics::kLimitNames.size()> limits;  ///< in the order of haptics::kLimitNames
};

/// Reads a model file by the path that an event gives.
using ReadModel = std::function<base::Result<fuzzy::ForceModel>(const std::string& path)>;

/// Runs `scenario` on `model` at 1 kHz; calls `each` once per tick. The same arguments give the same bits on every
/// machine. Refused: a model that ServoScene::make refuses, and whatever `read_model` refuses.
base::Result<RunSummary> runScenario(const Scenario& scenario, const fuzzy::ForceModel& model,
                                     const ReadModel& read_model, const std::function<void(const TraceTick&)>& each);

// The trace of a run as a CSV table; columns: docs/scenario.md.

/// Collects ticks as rows. The conditions become columns named after the inputs' ids; each tick must have these inputs.
class TraceTable {
 public:
  explicit TraceTable(const haptics::Conditions& conditions);

  void add(const TraceTick& tick);
  const std::string& text() const { return csv_.text(); }

 private:
  std::vector<std::string> conditions_;
  base::CsvWriter csv_;
};

}  // namespace tactus::simulation
