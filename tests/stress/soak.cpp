// Many random and adversarial models against exact rationals. Stops at the first disagreement, with what is needed to
// repeat it.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <iostream>
#include <mutex>
#include <thread>
#include <vector>

#include "core/base/text.h"
#include "core/model_io/model_file.h"

#include "tests/stress/agreement.h"
#include "tests/stress/hard_model.h"
#include "tests/support/random_model.h"

namespace tactus::stress {
namespace {

struct Options {
  std::uint64_t count = 100000;
  std::uint64_t seed = 1;
  std::uint64_t first = 0;
  int points = 6;
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
};

/// Ordinary, adversarial and hard models in turn.
fuzzy::ForceModel modelNumber(std::uint64_t number, base::Random& random) {
  switch (number % 4) {
    case 0:
      return support::randomModel(random, {.gaussians = false, .adversarial = false});
    case 1:
      return support::randomModel(random, {.gaussians = false, .adversarial = true});
    default:
      return hardModel(random);
  }
}

class Soak {
 public:
  explicit Soak(const Options& options) : options_(options), next_(options.first) {}

  bool run() {
    std::cout << options_.count << " models from number " << options_.first << ", seed " << options_.seed << ", "
              << options_.points << " points each, " << options_.threads << " threads\n"
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
      // Each model has a generator of its own, so that it can be repeated alone.
      base::Random random(options_.seed * 0x9E3779B97F4A7C15U + number);
      const fuzzy::ForceModel model = modelNumber(number, random);
      note(number, model, checkAgreement(model, random, options_.points));
    }
  }

  void note(std::uint64_t number, const fuzzy::ForceModel& model, const Agreement& found) {
    const std::lock_guard lock(mutex_);
    ++done_;
    largest_share_ = std::max(largest_share_, found.largest_share);
    largest_ulps_ = std::max(largest_ulps_, found.largest_ulps);
    if (found.largest_ulps > 4) ++above_four_ulps_;
    if (found.disagreement && !failed_.exchange(true)) {
      std::cout << "Disagreement in model " << number << ", seed " << options_.seed << "\n"
                << *found.disagreement << "\nRepeat: soak 1 --seed " << options_.seed << " --first " << number
                << " --points " << options_.points << '\n'
                << model_io::formatModel(model) << std::flush;
    }
    const auto now = std::chrono::steady_clock::now();
    if (now - last_report_ >= std::chrono::seconds(10)) {
      last_report_ = now;
      report();
    }
  }

  void report() const {
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start_;
    std::cout << done_ << " of " << options_.count << " models in " << base::formatFixed(taken.count(), 1)
              << " s; largest error " << base::formatFixed(largest_share_, 3)
              << " of the bound; batch and scene within " << base::formatFixed(largest_ulps_, 1)
              << " ulp of one point (above 4 ulp: " << above_four_ulps_ << " models)\n"
              << std::flush;
  }

  Options options_;
  std::atomic<std::uint64_t> next_;
  std::atomic<bool> failed_ = false;
  std::mutex mutex_;  // guards what follows
  std::uint64_t done_ = 0;
  std::uint64_t above_four_ulps_ = 0;
  double largest_share_ = 0;
  double largest_ulps_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point last_report_ = start_;
};

}  // namespace
}  // namespace tactus::stress

int main(int argc, char** argv) {
  tactus::stress::Options options;
  CLI::App app{"Random and adversarial models under every evaluator, against exact rational arithmetic"};
  app.add_option("count", options.count, "how many models");
  app.add_option("--seed", options.seed, "seed of the run");
  app.add_option("--first", options.first, "number of the first model");
  app.add_option("--points", options.points, "points for each model")->check(CLI::Range(1, 1000));
  app.add_option("--threads", options.threads, "threads")->check(CLI::Range(1, 256));
  CLI11_PARSE(app, argc, argv);
  return tactus::stress::Soak(options).run() ? 0 : 1;
}
