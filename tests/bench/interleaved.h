// Timing of many jobs in one run: every round gives each job one turn, in a new order, so that all of them see the same
// machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace tactus::bench {

/// Something that can be done `count` times with different data.
struct Job {
  std::string name;
  std::size_t count = 0;
  /// Does the evaluations first, first + 1, … and leaves one number of each in `out`.
  std::function<void(std::size_t first, std::span<double> out)> run;
};

/// Time of one evaluation, over the turns of a job.
struct Timing {
  double median_ns = 0;
  double min_ns = 0;
};

struct InterleavedOptions {
  int rounds = 200;
  double turn_ns = 1e6;  ///< about how long a turn takes; one evaluation where that alone takes longer
  std::uint64_t seed = 1;
};

struct InterleavedTimings {
  std::vector<Timing> timings;  ///< one per job
  double checksum = 0;          ///< sum of everything that was computed, so that nothing can be left out
};

/// The shorter a job's evaluations, the more of them make a turn; jobs walk through their data from turn to turn.
InterleavedTimings timeInterleaved(std::span<const Job> jobs, const InterleavedOptions& options);

}  // namespace tactus::bench
