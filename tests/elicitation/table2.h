// The votes of the paper's Table 2.
#pragma once

#include <vector>

#include "elicitation/force/force_voting.h"

namespace tactus::elicitation {

/// Votes for very small to very large at 0.1 to 1.1 N.
inline std::vector<VoteCounts> table2() {
  return {{0.1, {3, 1, 0, 0, 0}}, {0.2, {2, 1, 1, 0, 0}}, {0.3, {1, 1, 1, 1, 0}}, {0.4, {0, 2, 1, 0, 1}},
          {0.5, {0, 0, 2, 1, 1}}, {0.6, {0, 0, 2, 1, 1}}, {0.7, {0, 0, 1, 2, 1}}, {0.8, {0, 0, 1, 1, 2}},
          {0.9, {0, 0, 0, 2, 2}}, {1.0, {0, 0, 0, 1, 3}}, {1.1, {0, 0, 0, 0, 4}}};
}

}  // namespace tactus::elicitation
