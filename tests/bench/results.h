// What the benchmark found, and how it is written down.
#pragma once

#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tests/bench/cases.h"
#include "tests/bench/interleaved.h"

namespace tactus::bench {

struct ErrorFigures {
  double largest_n = 0;
  double mean_n = 0;
};

/// Absolute errors of the first forces against exact rationals, as far as there are both.
ErrorFigures errorAgainstExact(const Case& about, std::span<const double> forces_n);
/// Absolute differences from our one-point evaluator, as far as there are forces.
ErrorFigures differenceFromOnePoint(const Case& about, std::span<const double> forces_n);

/// A contender in the comparison of run time with error.
struct ContenderResult {
  std::string model;   ///< name of the case
  std::string family;  ///< Contender::family
  int setting = 0;
  Timing timing;
  ErrorFigures exact;
  ErrorFigures one_point;
};

/// What something costs when one number of the model is changed, or what a task costs.
struct CostResult {
  std::string part;   ///< rules, terms, experts, …, set-up, task
  std::string value;  ///< of the number, or the name of the task
  std::string what;   ///< one point, batch, compile, fuzzylite 100; empty for tasks
  Timing timing;
};

struct Results {
  std::vector<std::string> circumstances;  ///< lines about machine, build and peers
  std::vector<ContenderResult> contenders;
  std::optional<double> unit_ns;  ///< fuzzylite at resolution 100, clip, in the comparison
  std::vector<CostResult> costs;
  std::optional<double> cost_unit_ns;  ///< the same in the run of the costs
};

/// `123.4 ns`, `5.67 µs`.
std::string formatTime(double ns);

void printTables(const Results& results, std::ostream& out);

/// One table with everything: a row per contender and per cost.
std::string csvText(const Results& results);

}  // namespace tactus::bench
