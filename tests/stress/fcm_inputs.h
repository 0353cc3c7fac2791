// Random small inputs for the clustering, ordinary ones and traps.
#pragma once

#include <string>
#include <vector>

#include "core/base/random.h"

namespace tactus::stress {

struct FcmInput {
  std::vector<double> samples;
  std::vector<double> weights;  ///< none, or one per sample, some of them 0
  std::size_t clusters = 3;
  double m = 2;

  /// The numbers, as they were, for a report.
  std::string describe() const;
};

/// 1 to 40 samples: uniform, in clumps, whole numbers with many repeats, mirror-symmetric, all alike, with outliers; at
/// offsets up to 1e15 and scales from 1e-160 to 1e160; 1 to 6 clusters, m from 1.01 to 10, 2 in half of the cases.
FcmInput randomFcmInput(base::Random& random);

}  // namespace tactus::stress
