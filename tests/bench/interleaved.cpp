#include "tests/bench/interleaved.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "core/base/random.h"

namespace tactus::bench {
namespace {

using Clock = std::chrono::steady_clock;

/// One job with its place in its data and what it took so far.
class Runner {
 public:
  Runner(const Job& job, double turn_ns) : job_(&job), out_(job.count) {
    // Enough evaluations for an estimate: as many as take a fifth of a turn.
    std::size_t tried = 1;
    double taken_ns = timeStretch(tried);
    while (taken_ns < turn_ns / 5 && tried < job.count) {
      tried = std::min(job.count, tried * 4);
      taken_ns = timeStretch(tried);
    }
    const double wanted = std::max(1.0, turn_ns / (taken_ns / static_cast<double>(tried)));
    const auto count = static_cast<double>(job.count);
    stretch_ = static_cast<std::size_t>(std::min(wanted, count));
    passes_ = static_cast<int>(std::max(1.0, std::floor(wanted / count)));
  }

  void takeTurn() {
    double taken_ns = 0;
    for (int pass = 0; pass < passes_; ++pass) taken_ns += timeStretch(stretch_);
    per_evaluation_ns_.push_back(taken_ns / (static_cast<double>(stretch_) * passes_));
  }

  Timing timing() {
    std::sort(per_evaluation_ns_.begin(), per_evaluation_ns_.end());
    return {per_evaluation_ns_[per_evaluation_ns_.size() / 2], per_evaluation_ns_.front()};
  }

  double checksum() const { return checksum_; }

 private:
  double timeStretch(std::size_t length) {
    if (next_ + length > job_->count) next_ = 0;
    const std::span<double> out(out_.data(), length);
    const auto start = Clock::now();
    job_->run(next_, out);
    const double taken_ns = std::chrono::duration<double, std::nano>(Clock::now() - start).count();
    next_ += length;
    checksum_ = std::accumulate(out.begin(), out.end(), checksum_);
    return taken_ns;
  }

  const Job* job_;
  std::vector<double> out_;
  std::vector<double> per_evaluation_ns_;
  std::size_t next_ = 0;
  std::size_t stretch_ = 1;
  int passes_ = 1;
  double checksum_ = 0;
};

}  // namespace

InterleavedTimings timeInterleaved(std::span<const Job> jobs, const InterleavedOptions& options) {
  std::vector<Runner> runners;
  runners.reserve(jobs.size());
  for (const Job& job : jobs) runners.emplace_back(job, options.turn_ns);

  base::Random random(options.seed);
  std::vector<std::size_t> order(jobs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (int round = 0; round < options.rounds; ++round) {
    for (std::size_t i = order.size(); i > 1; --i) {
      std::swap(order[i - 1], order[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
    }
    for (const std::size_t job : order) runners[job].takeTurn();
  }

  InterleavedTimings out;
  for (Runner& runner : runners) {
    out.timings.push_back(runner.timing());
    out.checksum += runner.checksum();
  }
  return out;
}

}  // namespace tactus::bench
