#include "app/session/force_device.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/text.h"
#include "core/haptics/safety/thermal_budget.h"

namespace tactus::session {
namespace {

using base::ErrorCode;
using base::fail;
using base::formatNumber;
using base::Result;

/// How long a force without a time limit is felt before an answer; answers take a few seconds.
constexpr double kUnlimitedHoldS = 10;

/// The time at the full force, as the servo gives it (sources/stimulus_source.h).
double holdS(double force_n, const std::optional<double>& asked_s, const haptics::LimitSettings& limits) {
  const double hold_s = asked_s.value_or(kUnlimitedHoldS);
  return force_n > limits.continuous_force_n ? std::min(hold_s, limits.stimulus_hold_s) : hold_s;
}

Result<void> requireHolds(const std::string& place, double force_n, const experiments::ForceSettings& settings,
                          const haptics::LimitSettings& limits) {
  if (force_n > limits.force_cap_n) {
    return fail(ErrorCode::kValue, place, formatNumber(force_n) + " N",
                "at most " + formatNumber(limits.force_cap_n) + " N, the force cap of the device");
  }
  const auto asked_s = force_n > settings.continuous_n ? std::optional(settings.hold_limit_s) : std::nullopt;
  const double hold_s = holdS(force_n, asked_s, limits);
  const double largest_n =
      haptics::largestHoldN(settings.ramp_s, hold_s, limits.continuous_force_n, limits.thermal_window_s);
  if (force_n <= largest_n) return {};
  return fail(ErrorCode::kValue, place, formatNumber(force_n) + " N for " + formatNumber(hold_s) + " s",
              "at most " + base::formatFixed(largest_n, 2) + " N, which the motors of the device can hold so long");
}

}  // namespace

bool givesForce(std::string_view device) {
  constexpr std::string_view kWithout[] = {"virtual", "replay", "simulated", "dummy", "disconnected", "none"};
  const std::string lowered = base::lowered(std::string(base::trimmed(device)));
  return std::none_of(std::begin(kWithout), std::end(kWithout),
                      [&](std::string_view name) { return lowered.starts_with(name); });
}

Result<void> requireHolds(const experiments::ForceSettings& settings, const haptics::LimitSettings& limits) {
  std::vector<std::pair<std::string, double>> largest;
  for (const double force_n : settings.familiarisation_n) largest.emplace_back("familiarisation_n", force_n);
  if (settings.ascending) largest.emplace_back("ladder.highest_n", settings.ladder.highest_n);
  if (settings.random) largest.emplace_back("random_steps.highest_n", settings.random_steps.highest_n);
  for (const auto& [place, force_n] : largest) {
    if (auto ok = requireHolds(place, force_n, settings, limits); !ok) return ok;
  }
  return {};
}

double pauseBeforeS(const experiments::ForcePlan& plan, const haptics::ThermalBudget& budget,
                    const haptics::LimitSettings& limits) {
  const double force_n = plan.step.force_n;
  const haptics::PlannedHold planned{force_n, plan.ramp_s, holdS(force_n, plan.hold_limit_s, limits)};
  const auto rest_s = haptics::restBeforeS(budget, planned, limits.continuous_force_n, limits.thermal_window_s);
  return std::max(plan.pause_before_s, rest_s.value_or(0));
}

}  // namespace tactus::session
