#include "core/haptics/simulated/virtual_device_settings.h"

#include <cmath>
#include <string>

#include "core/base/text.h"

namespace tactus::haptics {
namespace {

constexpr std::string_view kFaultNames[] = {"unplugged", "stalled", "stuck_value", "not_a_number", "warm_motors"};
constexpr double kHuge = 1e6;

enum class Low { kIncluded, kExcluded };

struct Bounds {
  const char* place;
  double value;
  Low low_end;
  double low;
  double high;

  bool hold() const { return (low_end == Low::kIncluded ? value >= low : value > low) && value <= high; }
  std::string text() const {
    return "a number in " + std::string(low_end == Low::kIncluded ? "[" : "(") + base::formatNumber(low) + ", " +
           base::formatNumber(high) + "]";
  }
};

}  // namespace

std::string_view name(InjectedFault fault) noexcept { return kFaultNames[static_cast<int>(fault)]; }

std::optional<InjectedFault> faultNamed(std::string_view text) noexcept {
  for (int i = 0; i < static_cast<int>(std::size(kFaultNames)); ++i)
    if (kFaultNames[i] == text) return static_cast<InjectedFault>(i);
  return std::nullopt;
}

base::Result<void> check(const VirtualDeviceSettings& s) {
  const Bounds all[] = {
      {"mass_kg", s.mechanics.mass_kg, Low::kIncluded, 0.001, 100},
      {"damping_n_s_m", s.mechanics.damping_n_s_m, Low::kIncluded, 0, 1000},
      {"dry_friction_n", s.mechanics.dry_friction_n, Low::kIncluded, 0, 1000},
      {"hand.mass_kg", s.hand.mass_kg, Low::kIncluded, 0, 100},
      {"hand.damping_n_s_m", s.hand.damping_n_s_m, Low::kIncluded, 0, 1000},
      {"hand.stiffness_n_m", s.hand.stiffness_n_m, Low::kIncluded, 0, 1e5},
      {"hand.arm_mass_kg", s.hand.arm_mass_kg, Low::kIncluded, 0, 100},
      {"hand.arm_damping_n_s_m", s.hand.arm_damping_n_s_m, Low::kIncluded, 0, 1000},
      {"hand.arm_stiffness_n_m", s.hand.arm_stiffness_n_m, Low::kIncluded, 0, 1e5},
      {"start_mm", s.start_mm, Low::kIncluded, -1000, 1000},
      {"count_mm", s.count_mm, Low::kIncluded, 0, 10},
      {"delay_s", s.delay_s, Low::kIncluded, 0, 0.1},
      {"dropped_share", s.dropped_share, Low::kIncluded, 0, 1},
      {"stalls_per_s", s.stalls_per_s, Low::kIncluded, 0, 1000},
      {"shortest_stall_ms", static_cast<double>(s.shortest_stall_ms), Low::kIncluded, 1, kHuge},
      {"longest_stall_ms", static_cast<double>(s.longest_stall_ms), Low::kIncluded,
       static_cast<double>(s.shortest_stall_ms), kHuge},
      {"max_force_n", s.max_force_n, Low::kExcluded, 0, 100},
      {"continuous_force_n", s.continuous_force_n, Low::kExcluded, 0, 100},
      {"quiet_after_s", s.quiet_after_s, Low::kExcluded, 0, kHuge},
      {"live_time_constant_s", s.live_time_constant_s, Low::kIncluded, 0.002, 10},
      {"live_speed_mm_s", s.live_speed_mm_s, Low::kExcluded, 0, kHuge},
  };
  for (const Bounds& bounds : all)
    if (!bounds.hold())
      return base::fail(base::ErrorCode::kValue, std::string("device: ") + bounds.place,
                        base::formatNumber(bounds.value), bounds.text());
  if (s.steps_per_ms < 1 || s.steps_per_ms > 1000 || 1'000'000 % s.steps_per_ms != 0)
    return base::fail(base::ErrorCode::kValue, "device: steps_per_ms", std::to_string(s.steps_per_ms),
                      "a divisor of 1000000 in [1, 1000]");
  if (!(std::abs(dot(s.inwards, s.inwards) - 1) < 1e-9))
    return base::fail(base::ErrorCode::kValue, "device: inwards",
                      "a direction of length " + base::formatNumber(std::sqrt(dot(s.inwards, s.inwards))),
                      "one of length 1");
  for (std::size_t i = 0; i < s.faults.size(); ++i) {
    const FaultEvent& event = s.faults[i];
    if (!(event.start_s >= 0) || !std::isfinite(event.start_s) || !(event.duration_s > 0))
      return base::fail(
          base::ErrorCode::kValue, "device: faults[" + std::to_string(i) + "]",
          "start " + base::formatNumber(event.start_s) + " s, duration " + base::formatNumber(event.duration_s) + " s",
          "a start of at least 0 s and a duration above 0 s");
  }
  return {};
}

}  // namespace tactus::haptics
