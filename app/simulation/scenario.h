// A scenario: a simulated hand pushes the tube on a simulated device, with events at given times.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/haptics/safety/limit_settings.h"
#include "core/haptics/simulated/hand_plan.h"
#include "core/haptics/simulated/virtual_device.h"
#include "core/haptics/sources/force_source.h"
#include "core/haptics/sources/servo_scene.h"

namespace tactus::simulation {

// The movement of a scenario's hand: steps in sequence.

/// One step; it begins at the end of the previous one. Each kind lists the members that it uses.
struct MotionStep {
  enum class Kind {
    kRest,     ///< duration_s
    kStroke,   ///< minimum jerk by length_mm (negative: outward) within duration_s
    kGoTo,     ///< minimum jerk to position_mm within duration_s
    kPush,     ///< at speed_mm_s for duration_s
    kSwing,    ///< a sine of amplitude_mm and frequency_hz around the current place, for duration_s
    kPress,    ///< the button goes down; takes no time
    kRelease,  ///< the button goes up; takes no time
    kLetGo,    ///< the hand leaves the device; the button keeps its state; takes no time
    kHold,     ///< the hand holds the device again; takes no time
  };

  Kind kind = Kind::kRest;
  double duration_s = 0;
  double length_mm = 0;
  double position_mm = 0;
  double speed_mm_s = 0;
  double amplitude_mm = 0;
  double frequency_hz = 0;
};

/// The strokes of a nurse as steps: press, settle, push, hold, release, back, pause.
std::vector<MotionStep> spelledOut(const haptics::StrokeSeries& series);

/// The sum of all durations, s.
double durationS(const std::vector<MotionStep>& steps) noexcept;

/// The steps as a plan. It starts at position 0 with the button up; after the last step the hand rests.
haptics::HandPlan planOf(const std::vector<MotionStep>& steps);

/// A change at a given time. Absent members stay unchanged.
struct ScenarioEvent {
  std::string place;  ///< JSON pointer into the file
  double at_s = 0;
  haptics::Conditions conditions;  ///< only those that change
  std::string model;               ///< path of the new model file, as written in the scenario; empty: no change
  double fade_s = 0.05;            ///< fade time of model and conditions
  std::optional<haptics::ForceSource> source;
  std::optional<double> stimulus_n;  ///< force of a new stimulus
  std::optional<bool> armed;
  std::optional<bool> program_alive;  ///< false: the program's heartbeat stops
  bool stop = false;                  ///< the user presses Stop
  bool placement = false;             ///< another placement begins: the tube is out
};

struct Scenario {
  std::string name;
  haptics::Conditions conditions;
  haptics::VirtualDeviceSettings device;  ///< its plan is empty; its faults come from the events
  std::vector<MotionStep> motion;
  double tremor_mm = 0;  ///< added to the motion
  double tremor_hz = 10;
  haptics::EnableSettings enable;
  bool expert_limits = false;
  bool guard_velocity = true;
  double start_depth_mm = 0;
  double duration_s = 0;              ///< of the whole run
  std::vector<ScenarioEvent> events;  ///< ascending by time
};

/// Upper limit of a run; a placement takes about a minute.
inline constexpr double kLongestRunS = 3600;
inline constexpr std::size_t kMostScenarioBytes = std::size_t{1} << 20U;

/// Reads the text of a scenario file; errors carry the JSON place. Format: docs/scenario.md.
base::Result<Scenario> parseScenario(std::string_view text);
/// Reads the file `path` of at most 1 MiB.
base::Result<Scenario> readScenario(const std::string& path);

// The built-in scenarios, as the text of their files.
std::string_view placementScenarioJson();  ///< scenarios/placement.json
std::string_view oneStrokeScenarioJson();  ///< scenarios/one_stroke.json

/// The motion including the tremor.
haptics::HandPlan handPlan(const Scenario& scenario);

}  // namespace tactus::simulation
