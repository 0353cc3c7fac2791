// A scenario: a simulated hand on a simulated device, and what happens while it pushes the tube.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/simulation/hand_motion.h"
#include "core/base/error.h"
#include "core/haptics/safety/limit_settings.h"
#include "core/haptics/simulated/virtual_device_settings.h"
#include "core/haptics/sources/force_source.h"
#include "core/haptics/sources/servo_scene.h"

namespace tactus::simulation {

/// Something that changes at a time; what is absent stays as it was.
struct ScenarioEvent {
  std::string place;  ///< in the file, as a JSON pointer
  double at_s = 0;
  haptics::Conditions conditions;  ///< those that change
  std::string model;               ///< another model file, as written in the scenario; empty: none
  double fade_s = 0.05;            ///< of the hand-over of model and conditions
  std::optional<haptics::ForceSource> source;
  std::optional<double> stimulus_n;  ///< a new stimulus of this force
  std::optional<bool> armed;
  std::optional<bool> program_alive;  ///< false: the program's heartbeat stops
  bool stop = false;                  ///< somebody presses Stop
  bool placement = false;             ///< another placement begins: the tube is out
};

struct Scenario {
  std::string name;
  haptics::Conditions conditions;
  haptics::VirtualDeviceSettings device;  ///< its plan is left empty; its faults come from the events
  std::vector<MotionStep> motion;
  double tremor_mm = 0;  ///< on top of the motion
  double tremor_hz = 10;
  haptics::EnableSettings enable;
  bool expert_limits = false;
  bool guard_velocity = true;
  double start_depth_mm = 0;
  double duration_s = 0;              ///< of the whole run
  std::vector<ScenarioEvent> events;  ///< in the order of their times
};

/// No run is longer than this; a placement takes a minute.
inline constexpr double kLongestRunS = 3600;
inline constexpr std::size_t kMostScenarioBytes = std::size_t{1} << 20U;

/// Reads the text of a scenario file; errors carry the JSON place. Format: docs/scenario.md.
base::Result<Scenario> parseScenario(std::string_view text);
/// Reads the file `path` of at most 1 MiB.
base::Result<Scenario> readScenario(const std::string& path);

// Scenarios that the programs carry, as the text of their files.
std::string_view placementScenarioJson();  ///< scenarios/placement.json
std::string_view oneStrokeScenarioJson();  ///< scenarios/one_stroke.json

/// The motion with its tremor.
haptics::HandPlan handPlan(const Scenario& scenario);

}  // namespace tactus::simulation
