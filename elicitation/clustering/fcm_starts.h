// The starts of a clustering's descents (part of fcm.h).
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/random.h"
#include "elicitation/clustering/fcm_entries.h"

namespace tactus::elicitation {

// All functions need more entries than clusters and return ascending, distinct centers.

/// The quantiles (k + 1/2) / clusters, moved apart if they coincide.
std::vector<double> quantileStart(const FcmEntries& entries, std::size_t clusters);

/// The middles of equal parts of the range.
std::vector<double> equalWidthStart(const FcmEntries& entries, std::size_t clusters);

/// The means of the best division into runs, with each value in exactly one cluster: the limit of J for m near 1. Found
/// with certainty by dynamic programming (Fisher 1958). O(clusters * entries * log entries).
std::vector<double> bestRunsStart(const FcmEntries& entries, std::size_t clusters);

/// Random values, drawn with a probability that grows with the squared distance from the values drawn before (Arthur
/// and Vassilvitskii 2007), so that outliers can be chosen. Fewer centers if the remaining values are too close to
/// separate.
std::vector<double> spreadStart(const FcmEntries& entries, std::size_t clusters, base::Random& random);

}  // namespace tactus::elicitation
