#include "tests/vm/force_stream.h"

#include <algorithm>
#include <cmath>

#include "core/haptics/servo/servo_clock.h"

namespace tactus::vm {
namespace {

constexpr double kLargest = 0.9;

double shareOf(int tick, int ticks) { return kLargest * (2.0 * tick / ticks - 1); }

}  // namespace

ForceStream streamForces(haptics::HapticDevice& device, DeviceProcess& hand, int ticks) {
  const bool along_y = device.info().force_axes == 2;
  const double full_n = device.info().max_force_n;
  hand.tell("forget");
  std::vector<std::int64_t> written_ns;
  std::int64_t due_ns = haptics::monotonicNs();
  for (int tick = 0; tick < ticks; ++tick) {
    haptics::sleepUntil(due_ns += 1'000'000);
    const double force_n = full_n * shareOf(tick, ticks);
    written_ns.push_back(haptics::monotonicNs());
    device.write(along_y ? haptics::Vector3{0, 0, force_n} : haptics::Vector3{force_n, 0, 0}, written_ns.back());
  }
  haptics::sleepUntil(due_ns + 5'000'000);

  ForceStream stream;
  stream.written = ticks;
  std::vector<bool> arrived(written_ns.size(), false);
  for (const FeltForce& felt : hand.felt()) {
    const double share = along_y ? felt.y : felt.x;
    const int tick = static_cast<int>(std::lround((share / kLargest + 1) / 2 * ticks));
    if (tick < 0 || tick >= ticks || arrived[static_cast<std::size_t>(tick)]) continue;
    const auto at = static_cast<std::size_t>(tick);
    arrived[at] = true;
    stream.latency_us.push_back(static_cast<double>(felt.time_ns - written_ns[at]) * 1e-3);
    stream.largest_error = std::max(stream.largest_error, std::abs(share - shareOf(tick, ticks)));
  }
  stream.lost = static_cast<int>(std::ranges::count(arrived, false));
  return stream;
}

}  // namespace tactus::vm
