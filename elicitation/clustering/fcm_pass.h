// One pass over the data: all sums for a step of the descent (part of fcm.h).
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "elicitation/clustering/fcm_data.h"

namespace tactus::elicitation {

// The loops over the samples, compiled for several instruction sets and chosen at run time (part of fcm.h).

inline constexpr std::size_t kFcmLanes = 8;      // samples side by side, on every processor
inline constexpr std::size_t kFcmMostRows = 64;  // of as many samples as lanes, in one block

/// A run of samples and their scaling: x = (value * scale - shift) * stretch.
struct FcmBlock {
  const double* values = nullptr;
  const double* weights = nullptr;  ///< one per value; nullptr: all 1
  std::size_t count = 0;            ///< a multiple of kFcmLanes, at most kFcmMostRows times them
  double scale = 1;
  double shift = 0;
  double stretch = 1;
  double weight_scale = 1;  ///< factor of each weight; unused if all are 1
};

/// The centers at which the sums are computed.
struct FcmPlace {
  const double* centres = nullptr;  ///< scaled
  std::size_t clusters = 0;         ///< 1 to kMostClusters
  double m = 2;
};

/// Number of sums: u_k^m; u_k^m d_k; (u_k^m d_k)(u_l^m d_l)/h for k and l <= k; and h. Here d_k = x - v_k, u are the
/// memberships, and h = sum of u_k^m d_k^2. Each is summed over the samples, times their weights.
constexpr std::size_t fcmSumCount(std::size_t clusters) { return 2 * clusters + clusters * (clusters + 1) / 2 + 1; }

/// One set of loops, compiled for one instruction set. Every set does the same operations in the same order on each
/// lane, so all sets give the same bits.
struct FcmKernels {
  std::string_view name;  ///< sse2, avx2, avx512; portable if the processor is not x86-64
  /// For m = 2, without division by a distance: u_k is the product of the squared distances to the other centers,
  /// divided by the sum of such products. `sums`: fcmSumCount times kFcmLanes numbers, the lanes of a sum side by side.
  /// Returns false if the products become so small that they lose digits; `sums` is then invalid, and the caller uses
  /// `ratios`.
  bool (*products)(const FcmBlock& block, const FcmPlace& place, double* sums) noexcept;
  /// For every m: ratios of squared distances to the smallest one, raised to 1 / (m - 1). Never 0/0, never overflows.
  void (*ratios)(const FcmBlock& block, const FcmPlace& place, double* sums) noexcept;
};

/// The sets that this processor supports, the fastest last.
std::span<const FcmKernels> supportedFcmKernels() noexcept;

/// Sums over the samples at fixed centers. u: memberships, d_k = x - v_k.
struct FcmSums {
  std::vector<double> weight;  ///< of u_k^m
  std::vector<double> pull;    ///< of u_k^m d_k: half of J's descent direction
  /// Half of J's second derivatives with respect to the centers, c by c, row by row. With h = sum of u_k^m d_k^2 of one
  /// sample it is
  /// -(m + 1)/(m - 1) diag(weight) + 2m/(m - 1) sum of (u_k^m d_k)(u_l^m d_l)/h.
  std::vector<double> curvature;
  double objective = 0;  ///< J
};

/// Scratch memory for one c and m: O(c^2), without memberships.
class FcmPass {
 public:
  FcmPass(std::size_t clusters, double m);
  /// The same with the loops of one instruction set, for tests.
  FcmPass(std::size_t clusters, double m, const FcmKernels& kernels);

  /// Computes the sums at `centres` (scaled). Centers may coincide with values and with each other.
  void run(const FcmData& data, std::span<const double> centres, FcmSums& sums);

 private:
  void addBlock(const FcmBlock& block, std::span<const double> centres);
  void addTail(const FcmData& data, std::size_t begin, FcmBlock block, std::span<const double> centres);
  void finish(FcmSums& sums) const;

  std::size_t clusters_;
  double m_;
  FcmKernels kernels_;
  std::vector<double> lanes_;     // sums of one block, lane by lane: weight, pull, outer products, J
  std::vector<double> total_;     // sums of all blocks
  std::vector<double> rounding_;  // rounding errors of the additions to total_ (Neumaier 1974)
};

}  // namespace tactus::elicitation
