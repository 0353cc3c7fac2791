#include "tests/bench/tick_stream.h"

#include <algorithm>
#include <chrono>
#include <numeric>

#include "core/base/random.h"
#include "core/base/statistics.h"

namespace tactus::bench {
namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) { return std::chrono::duration<double, std::nano>(Clock::now() - start).count(); }

/// One number of each cache line, added up.
double readAll(std::span<const double> memory) {
  constexpr std::size_t kLine = 64 / sizeof(double);
  double sum = 0;
  for (std::size_t i = 0; i < memory.size(); i += kLine) sum += memory[i];
  return sum;
}

}  // namespace

Job batchesOf(const TickStream& stream) {
  return {stream.name, stream.length, [stream](std::size_t first, std::span<double> out) {
            if (first == 0) stream.restart();
            for (double& value : out) value = stream.next();
          }};
}

SingleTickTimings timeSingleTicks(std::span<const TickStream> streams, const SingleTickOptions& options) {
  SingleTickTimings out;
  out.times_ns.resize(streams.size());
  std::vector<std::size_t> done(streams.size());
  std::vector<std::size_t> order(streams.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (const TickStream& stream : streams) stream.restart();
  const std::vector<double> memory(options.evict_bytes / sizeof(double), 1.0);
  std::vector<double> nothing_ns;
  base::Random random(options.seed);
  for (int round = 0; round < options.rounds; ++round) {
    for (std::size_t i = order.size(); i > 1; --i) {
      std::swap(order[i - 1], order[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
    }
    for (const std::size_t which : order) {
      for (int tick = 0; tick <= options.ticks_per_turn; ++tick) {
        if (done[which] == streams[which].length) {
          streams[which].restart();
          done[which] = 0;
        }
        out.checksum += readAll(memory);
        const auto start = Clock::now();
        const double value = streams[which].next();
        const double taken_ns = since(start);
        if (tick > 0) out.times_ns[which].push_back(taken_ns);
        out.checksum += value;
        ++done[which];
      }
      nothing_ns.push_back(since(Clock::now()));
    }
  }
  out.clock_ns = base::median(nothing_ns);
  for (auto& times_ns : out.times_ns) {
    for (double& time_ns : times_ns) time_ns = std::max(0.0, time_ns - out.clock_ns);
  }
  return out;
}

}  // namespace tactus::bench
