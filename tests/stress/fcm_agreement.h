// What must hold for every clustering, checked on one input.
#pragma once

#include <optional>
#include <string>

#include "core/base/random.h"

#include "tests/stress/fcm_inputs.h"

namespace tactus::stress {

struct FcmAgreement {
  std::optional<std::string> disagreement;  ///< a sentence
  bool refused = false;
  bool unfinished = false;      ///< the iterations ran out
  double largest_j_error = 0;   ///< relative, reported J against long double
  double largest_j_excess = 0;  ///< J by the lowest J that other starts and the grid led to, minus 1
  int iterations = 0;
};

/// A result or the right refusal; centres finite, ascending, distinct, inside the data; J as the definition in long
/// double has it, not above where Bezdek's iteration leads from `starts` random starts, and with `grid` not above the
/// lowest J of a grid of centres; memberships positive with sum 1.
FcmAgreement checkClustering(const FcmInput& input, base::Random& random, int starts, bool grid);

}  // namespace tactus::stress
