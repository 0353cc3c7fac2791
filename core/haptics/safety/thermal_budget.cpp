#include "core/haptics/safety/thermal_budget.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/haptics/device/device.h"

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

ThermalBudget ThermalLedger::of(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  const auto kept = budgets_.find(id);
  return kept == budgets_.end() ? ThermalBudget{} : kept->second;
}

void ThermalLedger::keep(const std::string& id, const ThermalBudget& budget) {
  const std::lock_guard lock(mutex_);
  budgets_[id] = budget;
}

namespace {

/// A part of the window is at least and at most so long.
constexpr double kShortestNs = 1e6;
constexpr double kLongestNs = 1e14;

}  // namespace

void ThermalBudget::forgetUntil(std::int64_t part) noexcept {
  const std::int64_t steps = std::min<std::int64_t>(part - part_, kParts + 1);
  for (std::int64_t i = 1; i <= steps; ++i) spent_n2s_[static_cast<std::size_t>((part_ + i) % (kParts + 1))] = 0;
  part_ = part;
  // Summed anew, so that rounding does not gather over hours.
  if (steps > 0) sum_n2s_ = std::accumulate(spent_n2s_.begin(), spent_n2s_.end(), 0.0);
}

void ThermalBudget::advance(std::int64_t now_ns, double held_n, double rating_n, double window_s) noexcept {
  const double wanted_ns = std::max(kShortestNs, std::min(kLongestNs, 1e9 * window_s / kParts));
  const auto part_ns = static_cast<std::int64_t>(std::ceil(wanted_ns));
  if (part_ns_ == 0) start_ns_ = now_ns_ = now_ns;
  if (part_ns != part_ns_) {
    // Another window: all that was spent counts as spent just now.
    spent_n2s_.fill(0);
    spent_n2s_[0] = sum_n2s_;
    part_ns_ = part_ns;
    part_ = 0;
    start_ns_ = now_ns_;
  }
  const double elapsed_s = secondsBetween(now_ns_, now_ns);
  spend(now_ns, held_n);
  budget_n2s_ = rating_n * rating_n * window_s;
  const double allowed_n = std::sqrt(std::max(0.0, budget_n2s_ - sum_n2s_) / kReserveS);
  ceiling_n_ = std::min(allowed_n, ceiling_n_ + kRecoveryNS * elapsed_s);
}

void ThermalBudget::spend(std::int64_t now_ns, double held_n) noexcept {
  if (part_ns_ == 0) return;  // nothing was held before the first `advance`
  const double elapsed_s = secondsBetween(now_ns_, now_ns);
  now_ns_ = std::max(now_ns_, now_ns);
  forgetUntil((now_ns_ - start_ns_) / part_ns_);
  const double more_n2s = held_n * held_n * elapsed_s;
  spent_n2s_[static_cast<std::size_t>(part_ % (kParts + 1))] += more_n2s;
  sum_n2s_ += more_n2s;
}

ThermalBudget::Cooling ThermalBudget::cooling(int i) const noexcept {
  double spent_n2s = sum_n2s_;
  for (int forgotten = 1; forgotten <= i; ++forgotten) {
    spent_n2s -= spent_n2s_[static_cast<std::size_t>((part_ + forgotten) % (kParts + 1))];
  }
  const std::int64_t until_ns = start_ns_ + (part_ + i + 1) * part_ns_;
  return {secondsBetween(now_ns_, until_ns), std::max(0.0, spent_n2s)};
}

double ThermalBudget::share() const noexcept {
  if (part_ns_ == 0) return 0;
  return budget_n2s_ > 0 ? std::min(1.0, sum_n2s_ / budget_n2s_) : 1;
}

}  // namespace tactus::haptics
