// Many hands under the servo. Stops at the first thing that must not happen, with what is needed to repeat it.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <iostream>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "core/base/text.h"

#include "tests/stress/feel_run.h"

namespace tactus::stress {
namespace {

/// What is wrong with a run, or nothing.
std::string wrong(const FeelRun& run) {
  if (run.violation) return *run.violation;
  if (run.most_transitions > 0 && run.transitions > run.most_transitions)
    return std::to_string(run.transitions) + " transitions, at most " + std::to_string(run.most_transitions);
  if (run.most_ripple_n > 0 && run.ripple_n > run.most_ripple_n)
    return "ripple " + base::formatNumber(run.ripple_n) + " N, at most " + base::formatNumber(run.most_ripple_n);
  return {};
}

bool soak(std::uint64_t first, std::uint64_t count, unsigned threads) {
  std::atomic<std::uint64_t> next = first;
  std::atomic<bool> failed = false;
  std::mutex mutex;  // guards what follows
  FeelRun worst;
  int tripped = 0;
  const auto work = [&] {
    for (std::uint64_t number = next++; number < first + count && !failed; number = next++) {
      const FeelRun run = feelRun(number);
      const std::lock_guard lock(mutex);
      tripped += run.tripped ? 1 : 0;
      worst.ripple_n = std::max(worst.ripple_n, run.most_ripple_n > 0 ? run.ripple_n : 0);
      worst.transitions = std::max(worst.transitions, run.most_transitions > 0 ? run.transitions : 0);
      worst.lowest_certificate_mj = std::min(worst.lowest_certificate_mj, run.lowest_certificate_mj);
      worst.largest_depth_error_mm = std::max(worst.largest_depth_error_mm, run.largest_depth_error_mm);
      if (const std::string what = wrong(run); !what.empty() && !failed.exchange(true)) {
        std::cout << "Run " << number << ": " << what << "\n  " << run.what << "\n  Repeat: feel_soak 1 --first "
                  << number << '\n';
      }
    }
  };
  std::vector<std::thread> workers;
  for (unsigned t = 0; t < threads; ++t) workers.emplace_back(work);
  for (auto& worker : workers) worker.join();
  std::cout << next - first - threads << " runs from number " << first << "; tripped " << tripped
            << "; most transitions " << worst.transitions << ", largest ripple " << base::formatFixed(worst.ripple_n, 4)
            << " N, lowest certificate " << base::formatNumber(worst.lowest_certificate_mj)
            << " mJ, largest error of the depth " << base::formatNumber(worst.largest_depth_error_mm) << " mm\n";
  return !failed;
}

}  // namespace
}  // namespace tactus::stress

int main(int argc, char** argv) {
  std::uint64_t count = 50000;
  std::uint64_t first = 0;
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
  CLI::App app{"Simulated hands under the servo: stability, limits, energy and depth"};
  app.add_option("count", count, "how many runs");
  app.add_option("--first", first, "number of the first run");
  app.add_option("--threads", threads, "threads")->check(CLI::Range(1, 256));
  CLI11_PARSE(app, argc, argv);
  return tactus::stress::soak(first, count, threads) ? 0 : 1;
}
