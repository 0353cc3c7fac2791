// What the hand feels at one moment, for simulators that follow it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace tactus::link {

/// What is the same at many moments. Immutable.
struct LinkSetting {
  struct Region {
    double from_mm = 0;
    double to_mm = 0;
    std::string id;  ///< of the depth term
  };
  std::vector<Region> regions;                             ///< in the order of their depths
  std::vector<std::pair<std::string, double>> conditions;  ///< the inputs that the hand does not move: id and value
  bool simulated = false;                                  ///< the hand, or its device, is simulated or replayed
};

struct LinkState {
  double time_s = 0;  ///< since the run began
  double depth_mm = 0;
  double speed_mm_s = 0;
  double slip_speed_mm_s = 0;
  double force_n = 0;
  double model_force_n = 0;
  bool held = false;       ///< the hand holds the tube
  bool held_last = false;  ///< no rule fires, so the last force is held
  std::uint32_t stroke = 0;
};

/// Moments that follow each other, oldest first, in one setting.
struct LinkStates {
  std::shared_ptr<const LinkSetting> setting;
  std::vector<LinkState> states;
};

}  // namespace tactus::link
