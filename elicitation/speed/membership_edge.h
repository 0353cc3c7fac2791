// Where the membership in a cluster has fallen to a given value on the way to the next center.
#pragma once

#include <cstddef>
#include <span>

namespace tactus::elicitation {

/// The point between the center of `cluster` and the neighboring one `neighbor` (the index before or after it) where
/// the membership in `cluster` is alpha, rounded towards the cluster, so that it has at least alpha. The membership
/// falls all the way. `centres`: ascending, distinct. `m`: > 1. `alpha`: in (1/2, 1).
double membershipEdge(std::span<const double> centres, std::size_t cluster, std::size_t neighbor, double m,
                      double alpha);

}  // namespace tactus::elicitation
