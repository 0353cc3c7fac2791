// A small model whose forces can be worked out by hand.
#pragma once

#include "core/fuzzy/force_model.h"

namespace tactus::tests {

/// Inputs speed [0, 100] mm/s (slow, fast; they cross at 50) and depth [0, 10] mm (near until 5, far from 6 on, nothing
/// between). The output terms low and high are rectangles with the centroids 0.25 N and 0.75 N, whatever clips them.
/// Expert A: near and slow -> low, near and fast -> high, far -> high. Expert B: far -> low. B has a list of its own
/// for speed.
fuzzy::ForceModel twoExperts();

}  // namespace tactus::tests
