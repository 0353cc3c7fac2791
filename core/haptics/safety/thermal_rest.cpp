#include "core/haptics/safety/thermal_rest.h"

#include <algorithm>
#include <cmath>

namespace tactus::haptics {
namespace {

/// The force of a tick counts until the next one; ticks of the servo are shorter than this.
constexpr double kTickS = 0.002;

/// The time after which a hold has spent this energy per F²: a third of its ramp, then all.
double elapsedS(double heated_s, double ramp_s) {
  if (heated_s >= ramp_s / 3) return heated_s + 2 * ramp_s / 3;
  return std::cbrt(3 * ramp_s * ramp_s * heated_s);
}

double heatedBy(const PlannedHold& planned) { return planned.ramp_s / 3 + planned.hold_s + kTickS; }

}  // namespace

std::optional<double> restBeforeS(ThermalBudget budget, const PlannedHold& planned, double rating_n,
                                  double window_s) noexcept {
  if (planned.force_n <= 0) return 0;
  budget.refresh(rating_n, window_s);
  const double squared_n2 = planned.force_n * planned.force_n;
  const double whole_s = heatedBy(planned);
  // What old and new load together may reach, so that the ceiling is not below the force.
  const double most_n2s = rating_n * rating_n * window_s - ThermalBudget::kReserveS * squared_n2;
  if (squared_n2 * whole_s > most_n2s) return std::nullopt;

  double rest_s = std::max(0.0, (planned.force_n - budget.ceilingN()) / ThermalBudget::kRecoveryNS);
  for (int i = 0; i < ThermalBudget::kCoolingSteps; ++i) {
    const ThermalBudget::Cooling step = budget.cooling(i);
    const double left_n2s = most_n2s - step.spent_n2s;
    if (left_n2s < 0) {
      // The ceiling is below the force until this load is forgotten, and rises from there.
      const double allowed_n = std::sqrt(std::max(0.0, left_n2s / ThermalBudget::kReserveS + squared_n2));
      rest_s = std::max(rest_s, step.until_s + (planned.force_n - allowed_n) / ThermalBudget::kRecoveryNS);
    } else if (left_n2s < squared_n2 * whole_s) {
      // The new load may use up what is left just when the old one is forgotten.
      rest_s = std::max(rest_s, step.until_s - elapsedS(left_n2s / squared_n2, planned.ramp_s) + kTickS);
    }
  }
  return rest_s;
}

double largestHoldN(double ramp_s, double hold_s, double rating_n, double window_s) noexcept {
  const double heated_s = heatedBy({0, ramp_s, hold_s}) + ThermalBudget::kReserveS;
  return rating_n * std::sqrt(std::max(0.0, window_s) / heated_s);
}

}  // namespace tactus::haptics
