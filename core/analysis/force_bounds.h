// Proved bounds on the force, without sampling.
#pragma once

#include <optional>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

struct ForceBounds {
  double min_n = 0;
  double max_n = 0;
};

/// Bounds on the force of one expert at all points where it fires. Nothing if no rule can fire.
///
/// Lower bound: the centroid is at least c if the moment of the output set about c is not negative.
/// - The moment left of c is at most the sum over the terms that reach there.
/// - The moment right of c is at least any weighted mean of the same terms, if the weights add up to at most 1.
/// So c is a bound if there are weights with which each single term has no negative moment, at any strength from 0 to
/// the largest that its rules allow. The function returns the largest such c. The upper bound is the mirror image.
/// If a single term lies at an end of the range, as in ordered sets, the bound is the smallest (largest) centroid of
/// that term and therefore sharp. The proof also covers unions of terms, whose centroid may lie outside those of the
/// terms. A Gaussian reaches everywhere. If it is clipped, its bounds include the middle of the universe, which its
/// centroid approaches as the strength falls.
std::optional<ForceBounds> forceBounds(const fuzzy::ForceModel& model, std::size_t expert);

/// Bounds on the averaged force at all points where it fires. `always_fires`: one flag per expert, true only if it
/// never abstains. Any subset of the other experts may abstain.
std::optional<ForceBounds> forceBounds(const fuzzy::ForceModel& model, const std::vector<bool>& always_fires);

}  // namespace tactus::analysis
