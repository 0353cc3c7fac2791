// How well a clustering describes the data: validity indices.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace tactus::elicitation {

/// Indices of one clustering. Those that compare clusters are absent for a single cluster.
struct FcmValidity {
  double partition_coefficient = 1;            ///< mean of sum u^2, in [1/c, 1] (Bezdek 1974)
  std::optional<double> modified_coefficient;  ///< 1 - c/(c-1) (1 - partition coefficient), in [0, 1] (Dave 1996)
  double partition_entropy = 0;                ///< mean of -sum u ln u, natural logarithm (Bezdek 1974)
  /// J by n times the least squared distance of two centres (Xie and Beni 1991, with u^m); smaller is better.
  std::optional<double> xie_beni;
  /// Mean silhouette weighted by the difference of the two largest memberships (Campello and Hruschka 2006, alpha 1).
  std::optional<double> fuzzy_silhouette;
  std::optional<double> crisp_silhouette;  ///< mean silhouette of the nearest-centre clusters (Rousseeuw 1987)
  std::vector<std::size_t> sizes;          ///< samples nearest to each centre; a tie counts for the lower one
};

/// The indices of finite `samples` (at least one) for `centres` (ascending, distinct) and fuzziness `m` > 1.
/// Silhouettes use plain distances; a sample alone in its cluster has silhouette 0, and without a second cluster in use
/// they are absent. O(n log n), one copy of the samples.
FcmValidity fcmValidity(std::span<const double> samples, std::span<const double> centres, double m);

}  // namespace tactus::elicitation
