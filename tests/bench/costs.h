// What larger models, set-up and common tasks cost.
#pragma once

#include <string>
#include <vector>

#include "tests/bench/interleaved.h"

namespace tactus::bench {

/// A job with its place in the tables, see CostResult.
struct CostJob {
  std::string part;
  std::string value;
  std::string what;
  Job job;
};

/// One-point and batch evaluation, compiling, and fuzzylite at resolution 100 where it is installed, against the number
/// of rules, terms, inputs and experts; compiling and specializing the NGT model; a surface, a curve, and `tactus why`
/// at a point.
std::vector<CostJob> costJobs();

}  // namespace tactus::bench
