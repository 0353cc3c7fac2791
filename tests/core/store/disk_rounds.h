// Rounds of writing while the machine crashes or the program is killed, for the quick tests and the soak.
#pragma once

#include <cstdint>
#include <string>

namespace tactus::store {

struct RoundsOutcome {
  int rounds = 0;
  long long acknowledged = 0;         ///< records over all rounds
  long long unacknowledged_kept = 0;  ///< written but not yet acknowledged when it happened, and there afterwards
  double slowest_opening_s = 0;
  std::string complaint;  ///< the first thing that was not as it must be; empty when all was well
};

/// Crash pictures of the machine (faulty_disk.h) at random operations of sessions of `records` records, whose strokes
/// have `samples` samples. Each session ends with closing the file.
RoundsOutcome crashRounds(int rounds, int records, std::size_t samples, std::uint64_t seed);

/// The program `child` (kill_child.cpp) writes on and on and is killed after a random 1 to 300 ms, round after round on
/// the same file.
RoundsOutcome killRounds(const std::string& child, int rounds, std::uint64_t seed);

}  // namespace tactus::store
