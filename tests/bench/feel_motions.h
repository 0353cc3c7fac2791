// Simulated insertions, each with what was true beside what the servo saw.
#pragma once

#include <utility>
#include <vector>

#include "core/haptics/servo/servo_core.h"

namespace tactus::bench {

inline constexpr double kCountMm = 0.055;  ///< of the device

/// One tick as an estimator sees it, and as it was.
struct SeenTick {
  double tube_mm = 0;  ///< sum of the slip: what the renderer filters
  bool sliding = false;
  double true_depth_mm = 0;
  double true_speed_mm_s = 0;  ///< of the tube: 0 unless it slides in
  double rendered_n = 0;       ///< F_d of the renderer in the loop
};

/// What the hand does.
enum class Group { kSlowPush, kPush, kStroke, kTremorStroke };
inline constexpr std::pair<Group, const char*> kGroups[] = {{Group::kSlowPush, "push at 5 mm/s"},
                                                            {Group::kPush, "push at 80 mm/s"},
                                                            {Group::kStroke, "strokes"},
                                                            {Group::kTremorStroke, "strokes with tremor"}};

struct Motion {
  Group group = Group::kStroke;
  std::vector<SeenTick> ticks;
  double ripple_n = 0;  ///< of the force on the hand above 30 Hz, rms
  int transitions = 0;  ///< between stuck and sliding
};

/// Three hands; strokes of 60 mm from slow to fast at four depths, with and without tremor; even pushes. `orders` are
/// those of an insertion. Deterministic.
std::vector<Motion> motions(const haptics::ServoOrders& orders);

}  // namespace tactus::bench
