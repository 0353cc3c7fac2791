// How long motors must rest before they can hold a force.
#pragma once

#include <optional>

#include "core/haptics/safety/thermal_budget.h"

namespace tactus::haptics {

/// A force that the servo is to give in full: the heat of the motors must not limit it.
struct PlannedHold {
  double force_n = 0;  ///< >= 0
  double ramp_s = 0;   ///< from zero to the force, linearly; >= 0
  double hold_s = 0;   ///< at the full force; >= 0
};

/// The shortest rest without force, s, counted from the last call of the budget, after which the ceiling of the budget
/// stays at or above `planned.force_n` through ramp and hold. A longer rest is as good. Nothing if cold motors cannot
/// hold it either. `rating_n`, `window_s`: as in ThermalBudget::advance.
/// Exact for the budget's rule (remaining energy / 2 s, parts of the window, recovery by 0.5 N/s); ticks of up to 2 ms
/// are counted in. Example: a Touch (0.88 N over 60 s) that held 1.7 N four times for 3 s, every 6 s, rests 37.4 s
/// before the fifth time. Thread: any. Real-time safe: yes.
std::optional<double> restBeforeS(ThermalBudget budget, const PlannedHold& planned, double rating_n,
                                  double window_s) noexcept;

/// The largest force, N, that cold motors can hold through `ramp_s` and `hold_s`.
double largestHoldN(double ramp_s, double hold_s, double rating_n, double window_s) noexcept;

}  // namespace tactus::haptics
