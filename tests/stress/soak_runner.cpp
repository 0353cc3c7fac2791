#include "tests/stress/soak_runner.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <iostream>
#include <mutex>
#include <thread>
#include <vector>

#include "core/base/text.h"

namespace tactus::stress {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kReportEvery{10};

class Soak {
 public:
  Soak(const SoakOptions& options, const std::string& repeat, const std::function<SoakCase(std::uint64_t)>& run,
       const std::function<std::string()>& summary)
      : options_(options), repeat_(repeat), run_(run), summary_(summary), next_(options.first) {}

  bool run() {
    const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
    const unsigned threads = options_.threads > 0 ? options_.threads : cores;
    std::cout << options_.count << " cases from number " << options_.first << ", seed " << options_.seed << ", "
              << threads << " threads\n"
              << std::flush;
    std::vector<std::thread> workers;
    for (unsigned t = 0; t < threads; ++t) workers.emplace_back([this] { work(); });
    for (auto& worker : workers) worker.join();
    report();
    return !failed_;
  }

 private:
  void work() {
    while (!failed_) {
      const std::uint64_t number = next_++;
      if (number >= options_.first + options_.count) return;
      note(number, run_(number));
    }
  }

  void note(std::uint64_t number, const SoakCase& found) {
    const std::lock_guard lock(mutex_);
    ++done_;
    found.note();
    if (!found.trouble.empty() && !failed_.exchange(true)) {
      std::cout << "Case " << number << ", seed " << options_.seed << ": " << found.trouble << "\nRepeat: " << repeat_
                << " 1 --seed " << options_.seed << " --first " << number << '\n'
                << std::flush;
    }
    if (Clock::now() - last_report_ >= kReportEvery) report();
  }

  void report() {
    last_report_ = Clock::now();
    const std::chrono::duration<double> taken = last_report_ - start_;
    std::cout << done_ << " of " << options_.count << " in " << base::formatFixed(taken.count(), 1) << " s; "
              << summary_() << '\n'
              << std::flush;
  }

  const SoakOptions& options_;
  const std::string& repeat_;
  const std::function<SoakCase(std::uint64_t)>& run_;
  const std::function<std::string()>& summary_;
  std::atomic<std::uint64_t> next_;
  std::atomic<bool> failed_ = false;
  std::mutex mutex_;  // guards what follows, and the sums of the caller
  std::uint64_t done_ = 0;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_report_ = start_;
};

}  // namespace

void addSoakOptions(CLI::App& app, SoakOptions& options) {
  app.add_option("count", options.count, "how many cases");
  app.add_option("--seed", options.seed, "seed of the run");
  app.add_option("--first", options.first, "number of the first case");
  app.add_option("--threads", options.threads, "threads; 0: one for each core")->check(CLI::Range(0, 256));
}

base::Random caseRandom(const SoakOptions& options, std::uint64_t number) {
  return base::Random(options.seed * 0x9E3779B97F4A7C15U + number);
}

bool soak(const SoakOptions& options, const std::string& repeat, const std::function<SoakCase(std::uint64_t)>& run,
          const std::function<std::string()>& summary) {
  return Soak(options, repeat, run, summary).run();
}

}  // namespace tactus::stress
