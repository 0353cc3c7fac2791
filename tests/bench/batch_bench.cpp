// What a batch costs, in the same points one by one: experts who answered a part of the items, short and long batches.
// Turns of both alternate in one run, in time of the processor; the largest difference of the forces stands beside it.
#include <algorithm>
#include <cmath>
#include <ctime>
#include <iomanip>
#include <iostream>

#include "core/base/check.h"
#include "core/base/random.h"
#include "core/fuzzy/batch.h"

#include "tests/bench/cases.h"

namespace tactus::bench {
namespace {

constexpr int kRounds = 15;
constexpr double kTurnNs = 2e6;

/// Experts as in syntheticExperts, each without some rules: every rule is missing with this chance.
fuzzy::ForceModel withMissingRules(int experts, bool own_terms, int percent) {
  fuzzy::ForceModel model = syntheticExperts(experts, own_terms);
  base::Random random(7);
  for (fuzzy::Expert& expert : model.experts) {
    for (fuzzy::Rule& rule : expert.rules) rule.enabled = random.below(100) >= percent;
    expert.rules[static_cast<std::size_t>(random.below(45))].enabled = true;
  }
  return model;
}

double processorNs() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e9 + static_cast<double>(now.tv_nsec);
}

template <class Work>
double nsOf(Work&& work, int times) {
  const double start = processorNs();
  for (int i = 0; i < times; ++i) work();
  return (processorNs() - start) / times;
}

double medianOf(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + kRounds / 2, values.end());
  return values[kRounds / 2];
}

/// One row of the table: batches of `count` points against these points one by one.
void compare(int experts, bool own_terms, int percent, std::size_t count) {
  const auto compiled = fuzzy::compile(withMissingRules(experts, own_terms, percent));
  TACTUS_CHECK(compiled.has_value());
  Points points = shuffledPoints(syntheticExperts(1), std::vector<std::optional<double>>(4));
  std::vector<std::span<const double>> columns;
  for (const auto& column : points.columns) columns.push_back(std::span(column).first(count));
  std::vector<double> force_n(count), alone_n(count);
  std::vector<std::uint8_t> fired(count), alone_fired(count);
  const auto batch = [&] { fuzzy::evaluateBatch(*compiled, columns, {force_n, fired}); };
  const auto alone = [&] {
    for (std::size_t p = 0; p < count; ++p) {
      const auto force = compiled->evaluate(points.row(p));
      alone_n[p] = force.force_n;
      alone_fired[p] = force.fired ? 1 : 0;
    }
  };
  const int times = static_cast<int>(std::clamp(kTurnNs / std::max(nsOf(alone, 2), 1.0), 1.0, 1e5));
  std::vector<double> batch_ns, alone_ns, ratios;
  for (int round = 0; round < kRounds; ++round) {
    alone_ns.push_back(nsOf(alone, times));
    batch_ns.push_back(nsOf(batch, times));
    ratios.push_back(batch_ns.back() / alone_ns.back());
  }
  TACTUS_CHECK(fired == alone_fired);
  double difference_n = 0;
  for (std::size_t p = 0; p < count; ++p) difference_n = std::max(difference_n, std::abs(force_n[p] - alone_n[p]));
  const auto per_point = [count](double ns) { return ns / static_cast<double>(count); };
  std::cout << std::setw(7) << experts << "  " << (own_terms ? "own   " : "shared") << std::setw(9) << percent
            << std::setw(8) << count << std::fixed << std::setprecision(1) << std::setw(13)
            << per_point(medianOf(alone_ns)) << std::setw(13) << per_point(medianOf(batch_ns)) << std::setprecision(2)
            << std::setw(15) << medianOf(ratios) << std::scientific << std::setw(15) << difference_n
            << std::defaultfloat << std::endl;
}

}  // namespace
}  // namespace tactus::bench

int main() {
  using tactus::bench::compare;
  std::cout << "experts  terms   missing %  points  one by one, ns  batch, ns  batch / points  difference, N\n";
  for (const bool own_terms : {false, true}) {
    for (const int experts : {1, 4, 32, 256, 1024}) {
      const std::size_t count = experts < 256 ? 4096 : 512;
      for (const int percent : {0, 30, 60, 90}) compare(experts, own_terms, percent, count);
      for (const std::size_t few : {1, 2, 4, 8, 16, 31, 33}) compare(experts, own_terms, 30, few);
    }
  }
}
