// Validity indices: how well a clustering describes the data.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace tactus::elicitation {

/// Indices of one clustering. Indices that compare clusters are empty for a single cluster.
struct FcmValidity {
  double partition_coefficient = 1;            ///< mean of sum u^2, in [1/c, 1] (Bezdek 1974)
  std::optional<double> modified_coefficient;  ///< 1 - c/(c-1) (1 - partition coefficient), in [0, 1] (Dave 1996)
  double partition_entropy = 0;                ///< mean of -sum u ln u, natural logarithm (Bezdek 1974)
  /// J divided by n times the least squared distance of two centers (Xie and Beni 1991, with u^m); smaller is better.
  std::optional<double> xie_beni;
  /// Mean silhouette weighted by the difference of the two largest memberships (Campello and Hruschka 2006, alpha 1).
  std::optional<double> fuzzy_silhouette;
  std::optional<double> crisp_silhouette;  ///< mean silhouette of the nearest-center clusters (Rousseeuw 1987)
  std::vector<std::size_t> sizes;          ///< samples nearest to each center; a tie counts for the lower one
};

/// The indices for finite `samples` (at least one), `centres` (ascending, distinct) and fuzziness `m` > 1. Silhouettes
/// use plain distances. A sample alone in its cluster has silhouette 0. If only one cluster has samples, the
/// silhouettes are empty. O(n log n), one copy of the samples.
FcmValidity fcmValidity(std::span<const double> samples, std::span<const double> centres, double m);

}  // namespace tactus::elicitation
