// Where the descents of a clustering begin (part of fcm.h).
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/random.h"
#include "elicitation/clustering/fcm_entries.h"

namespace tactus::elicitation {

// All take more entries than clusters and give ascending, distinct centres.

/// The quantiles (k + 1/2) / clusters, moved apart where they fall on one value.
std::vector<double> quantileStart(const FcmEntries& entries, std::size_t clusters);

/// The middles of equal parts of the range.
std::vector<double> equalWidthStart(const FcmEntries& entries, std::size_t clusters);

/// The means of the best division into runs, where each value belongs to one cluster alone: what J tends to for m near
/// 1, found for certain by dynamic programming (Fisher 1958). O(clusters * entries * log entries).
std::vector<double> bestRunsStart(const FcmEntries& entries, std::size_t clusters);

/// Values drawn with a probability that grows with the squared distance to those drawn before (Arthur and Vassilvitskii
/// 2007), so that outliers get their chance. Fewer than asked for where the rest is too close to tell apart.
std::vector<double> spreadStart(const FcmEntries& entries, std::size_t clusters, base::Random& random);

}  // namespace tactus::elicitation
