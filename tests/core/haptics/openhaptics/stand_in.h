// What the stand-in for libHD pretends to be and what was done to it. A test gets at it through `standIn()` of the
// loaded library.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

namespace tactus::haptics::stand_in {

struct State {
  // What it pretends to be.
  double position_mm[3] = {0, 0, 0};
  double velocity_mm_s[3] = {0, 0, 0};
  int buttons = 0;
  double max_force_n = 3.3;
  double continuous_force_n = 0.88;
  double stiffness_n_mm = 0.5;
  std::vector<std::string> accepted_names = {""};  ///< empty text: the default device
  unsigned init_error = 0x0302;                    ///< for a name that is not accepted
  bool taken_elsewhere = false;
  bool gives_handle_with_error = false;
  unsigned calibration = 0x5000;
  unsigned calibration_after_update = 0x5000;
  int calibration_styles = 4;
  unsigned refused_capability = 0;  ///< hdEnable of this one fails
  unsigned schedule_error = 0;
  unsigned rate_error = 0;
  unsigned start_error = 0;
  unsigned enable_again_error = 0;             ///< of hdEnable while the loop runs
  std::vector<unsigned> errors_of_next_frame;  ///< the last one is the newest
  bool error_for_ever = false;                 ///< hdGetError never says "none"
  bool threaded = false;                       ///< the scheduler has a thread; otherwise a test steps it

  // What was done to it.
  std::vector<std::string> calls;  ///< all but those of each frame
  std::vector<unsigned> calibration_updates;
  std::atomic<int> frames{0};
  double force_n[3] = {0, 0, 0};  ///< of the last whole frame
  double largest_force_n = 0;     ///< of all frames
  bool force_output = false;
  unsigned long rate_hz = 0;
  bool scheduled = false;
  bool running = false;
  int open_devices = 0;
};

/// One round of the scheduler: the callback, if there is one and the scheduler runs. Returns whether it was called.
using Step = bool (*)();
using GetState = State* (*)();
/// Back to a device that is not open.
using Reset = void (*)();

}  // namespace tactus::haptics::stand_in
