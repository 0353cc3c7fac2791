// Many random small inputs under the clustering. Stops at the first disagreement, with what is needed to repeat it.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <iostream>
#include <mutex>
#include <thread>
#include <vector>

#include "core/base/text.h"

#include "tests/stress/fcm_agreement.h"

namespace tactus::stress {
namespace {

struct Options {
  std::uint64_t count = 1000000;
  std::uint64_t seed = 1;
  std::uint64_t first = 0;
  int starts = 2;
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
};

constexpr std::uint64_t kGridEvery = 16;

class FcmSoak {
 public:
  explicit FcmSoak(const Options& options) : options_(options), next_(options.first) {}

  bool run() {
    std::cout << options_.count << " inputs from number " << options_.first << ", seed " << options_.seed << ", "
              << options_.starts << " other starts each, a grid for one in " << kGridEvery << ", " << options_.threads
              << " threads\n"
              << std::flush;
    std::vector<std::thread> workers;
    for (unsigned t = 0; t < options_.threads; ++t) workers.emplace_back([this] { work(); });
    for (auto& worker : workers) worker.join();
    report();
    return !failed_;
  }

 private:
  void work() {
    while (!failed_) {
      const std::uint64_t number = next_++;
      if (number >= options_.first + options_.count) return;
      // Each input has a generator of its own, so that it can be repeated alone.
      base::Random random(options_.seed * 0x9E3779B97F4A7C15U + number);
      const FcmInput input = randomFcmInput(random);
      note(number, input, checkClustering(input, random, options_.starts, number % kGridEvery == 0));
    }
  }

  void note(std::uint64_t number, const FcmInput& input, const FcmAgreement& found) {
    const std::lock_guard lock(mutex_);
    ++done_;
    refused_ += found.refused ? 1 : 0;
    unfinished_ += found.unfinished ? 1 : 0;
    largest_j_error_ = std::max(largest_j_error_, found.largest_j_error);
    most_iterations_ = std::max(most_iterations_, found.iterations);
    if (found.disagreement && !failed_.exchange(true)) {
      std::cout << "Disagreement in input " << number << ", seed " << options_.seed << "\n"
                << *found.disagreement << "\nRepeat: fcm_soak 1 --seed " << options_.seed << " --first " << number
                << " --starts " << options_.starts << '\n'
                << input.describe() << std::flush;
    }
    const auto now = std::chrono::steady_clock::now();
    if (now - last_report_ >= std::chrono::seconds(10)) {
      last_report_ = now;
      report();
    }
  }

  void report() const {
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start_;
    std::cout << done_ << " of " << options_.count << " inputs in " << base::formatFixed(taken.count(), 1) << " s; "
              << refused_ << " refused for too few distinct values; J within " << base::formatNumber(largest_j_error_)
              << " of its definition; at most " << most_iterations_ << " iterations, " << unfinished_
              << " ran out of them\n"
              << std::flush;
  }

  Options options_;
  std::atomic<std::uint64_t> next_;
  std::atomic<bool> failed_ = false;
  std::mutex mutex_;  // guards what follows
  std::uint64_t done_ = 0;
  std::uint64_t refused_ = 0;
  std::uint64_t unfinished_ = 0;
  double largest_j_error_ = 0;
  int most_iterations_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point last_report_ = start_;
};

}  // namespace
}  // namespace tactus::stress

int main(int argc, char** argv) {
  tactus::stress::Options options;
  CLI::App app{"Random small inputs under the clustering, against a textbook iteration in long double and a grid"};
  app.add_option("count", options.count, "how many inputs");
  app.add_option("--seed", options.seed, "seed of the run");
  app.add_option("--first", options.first, "number of the first input");
  app.add_option("--starts", options.starts, "other starts for each input")->check(CLI::Range(0, 1000));
  app.add_option("--threads", options.threads, "threads")->check(CLI::Range(1, 256));
  CLI11_PARSE(app, argc, argv);
  return tactus::stress::FcmSoak(options).run() ? 0 : 1;
}
