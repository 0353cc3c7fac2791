// Bounds on the force that hold everywhere, by proof and not by looking.
#pragma once

#include <optional>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

struct ForceBounds {
  double min_n = 0;
  double max_n = 0;
};

/// Bounds on the force of one expert wherever it fires; nothing where no rule can ever fire.
///
/// Lower bound: the centroid is at least c where the moment of the output set about c is not negative. The moment left
/// of c is at most the sum over the terms that reach there; the moment right of c is at least any weighted mean of the
/// same terms, with weights that add up to at most 1. So c is a bound where weights exist with which each term alone
/// has no negative moment at any strength from 0 to the largest that its rules allow; the largest such c is taken. The
/// upper bound mirrors it. Where one term alone lies at an end of the range, as in ordered sets, the bound is the
/// smallest (largest) centroid of that term alone, so it is sharp; unions of terms, whose centroid may lie outside
/// those of the terms, are covered too. A Gaussian reaches everywhere: clipped, its bounds take in the middle of the
/// universe, which its centroid approaches as the strength falls.
std::optional<ForceBounds> forceBounds(const fuzzy::ForceModel& model, std::size_t expert);

/// Bounds on the averaged force wherever it fires. `always_fires`: one flag per expert, true only where it never
/// abstains. Any subset of the other experts may abstain.
std::optional<ForceBounds> forceBounds(const fuzzy::ForceModel& model, const std::vector<bool>& always_fires);

}  // namespace tactus::analysis
