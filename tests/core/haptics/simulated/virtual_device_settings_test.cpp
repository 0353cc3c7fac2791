#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <utility>

#include "core/haptics/simulated/virtual_device.h"

namespace tactus::haptics {
namespace {

TEST(VirtualDeviceSettings, OutOfRangeIsRefusedInOneSentence) {
  const auto message = [](auto change) {
    VirtualDeviceSettings settings;
    change(settings);
    const auto made = VirtualDevice::make(std::move(settings));
    return made ? std::string("accepted") : made.error().message();
  };
  using S = VirtualDeviceSettings;
  EXPECT_EQ(message([](S&) {}), "accepted");
  EXPECT_EQ(message([](S& s) { s.delay_s = 0.2; }), "device: delay_s: found 0.2, wanted a number in [0, 0.1]");
  EXPECT_EQ(message([](S& s) { s.mechanics.mass_kg = 0; }),
            "device: mass_kg: found 0, wanted a number in [0.001, 100]");
  EXPECT_EQ(message([](S& s) { s.max_force_n = 0; }), "device: max_force_n: found 0, wanted a number in (0, 100]");
  EXPECT_EQ(message([](S& s) { s.longest_stall_ms = 1; }),
            "device: longest_stall_ms: found 1, wanted a number in [2, 1e+06]");
  EXPECT_EQ(message([](S& s) { s.steps_per_ms = 7; }),
            "device: steps_per_ms: found 7, wanted a divisor of 1000000 in [1, 1000]");
  EXPECT_EQ(message([](S& s) {
              s.inwards = {0, 0, 2};
            }),
            "device: inwards: found a direction of length 2, wanted one of length 1");
  EXPECT_EQ(
      message([](S& s) {
        s.faults = {{InjectedFault::kStalled, -1, 2}};
      }),
      "device: faults[0]: found start -1 s, duration 2 s, wanted a start of at least 0 s and a duration above 0 s");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (double S::*member :
       {&S::start_mm, &S::count_mm, &S::delay_s, &S::dropped_share, &S::stalls_per_s, &S::max_force_n,
        &S::continuous_force_n, &S::quiet_after_s, &S::live_time_constant_s, &S::live_speed_mm_s})
    EXPECT_NE(message([&](S& s) { s.*member = nan; }), "accepted");
}

TEST(InjectedFault, NamesReadBack) {
  for (const InjectedFault fault : {InjectedFault::kUnplugged, InjectedFault::kStalled, InjectedFault::kStuckValue,
                                    InjectedFault::kNotANumber, InjectedFault::kWarmMotors})
    EXPECT_EQ(faultNamed(name(fault)), fault);
  EXPECT_FALSE(faultNamed("on_fire"));
}

}  // namespace
}  // namespace tactus::haptics
