// What the long runs have in common: numbered cases on all cores, a word on progress, and an end at the first one that
// goes wrong.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "core/base/random.h"

namespace CLI {
class App;
}

namespace tactus::stress {

struct SoakOptions {
  std::uint64_t count = 0;  ///< cases
  std::uint64_t seed = 1;   ///< of the run
  std::uint64_t first = 0;  ///< number of the first case
  unsigned threads = 0;     ///< 0: one for each core
};

/// `count`, `--seed`, `--first` and `--threads` of the command line; what `options` holds is the default.
void addSoakOptions(CLI::App& app, SoakOptions& options);

/// The generator of one case, of its own, so that the case can be repeated alone.
base::Random caseRandom(const SoakOptions& options, std::uint64_t number);

struct SoakCase {
  std::function<void()> note;  ///< adds the case to the sums; never called by two threads at once
  std::string trouble;         ///< what went wrong and all that is needed to look at it; empty where nothing did
};

/// Runs the cases `first` to `first + count - 1`; `run` is called by all threads. Prints `summary()`, which may read
/// the sums, every ten seconds and at the end. Stops at the first case in trouble and prints it with the command that
/// repeats it, `repeat` and its options. Returns whether none was.
bool soak(const SoakOptions& options, const std::string& repeat, const std::function<SoakCase(std::uint64_t)>& run,
          const std::function<std::string()>& summary);

}  // namespace tactus::stress
