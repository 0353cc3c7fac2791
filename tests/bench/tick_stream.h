// Single ticks one after the other, timed alone: medians and tails of what a loop calls once per millisecond.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "tests/bench/interleaved.h"

namespace tactus::bench {

/// `length` ticks that follow each other, and a way back to the first.
struct TickStream {
  std::string name;
  std::size_t length = 0;
  std::function<void()> restart;
  std::function<double()> next;  ///< one number of each tick, so that nothing can be left out
  bool quick_restart = true;     ///< beside the ticks that follow; otherwise batches would time it as well
};

/// The ticks of a stream as a job for batches: begins anew whenever its first evaluation is asked for.
/// `quick_restart` only.
Job batchesOf(const TickStream& stream);

struct SingleTickOptions {
  int rounds = 200;
  int ticks_per_turn = 100;
  /// Before each tick so many bytes are read, which drives code and data out of the caches; 0: the tick follows the
  /// tick before it.
  std::size_t evict_bytes = 0;
  std::uint64_t seed = 1;
};

struct SingleTickTimings {
  std::vector<std::vector<double>> times_ns;  ///< per stream; the reading of the clock subtracted
  double clock_ns = 0;                        ///< median between two readings of the clock with nothing in between
  double checksum = 0;
};

/// Each stream takes its turns of a few ticks in every round, in a new order each time. The first tick of a turn, which
/// comes after all the other streams, is not counted.
SingleTickTimings timeSingleTicks(std::span<const TickStream> streams, const SingleTickOptions& options);

}  // namespace tactus::bench
