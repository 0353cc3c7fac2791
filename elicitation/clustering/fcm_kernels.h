// The loops over the samples, compiled for several instruction sets and chosen at run time (part of fcm.h).
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace tactus::elicitation {

inline constexpr std::size_t kFcmLanes = 8;  // samples side by side, whatever the processor

/// A run of samples and how they are scaled: x = (value * scale - shift) * stretch.
struct FcmBlock {
  const double* values = nullptr;
  const double* weights = nullptr;  ///< one per value; nullptr: all 1
  std::size_t count = 0;            ///< a multiple of kFcmLanes
  double scale = 1;
  double shift = 0;
  double stretch = 1;
  double weight_scale = 1;  ///< for each weight; nothing where all are 1
};

/// Where the sums are taken.
struct FcmPlace {
  const double* centres = nullptr;  ///< scaled
  std::size_t clusters = 0;         ///< 1 to kMostClusters
  double m = 2;
};

/// How many sums there are: u_k^m; u_k^m d_k; for k, l <= k (u_k^m d_k)(u_l^m d_l)/h; and h; with d_k = x - v_k, u the
/// memberships and h = sum of u_k^m d_k^2, of each sample times its weight.
constexpr std::size_t fcmSumCount(std::size_t clusters) { return 2 * clusters + clusters * (clusters + 1) / 2 + 1; }

/// The same source compiled for one instruction set. All do the same operations in the same order on each lane, so all
/// give the same bits.
struct FcmKernels {
  std::string_view name;  ///< sse2, avx2, avx512; or portable on other processors
  /// For m = 2, without divisions by a distance: u_k is the product of the squared distances to the other centres by
  /// the sum of such products. `sums` gets fcmSumCount times kFcmLanes numbers, a sum's lanes together. Gives false
  /// where products fall so low that they lose digits; then `sums` is of no use and `ratios` is called for.
  bool (*products)(const FcmBlock& block, const FcmPlace& place, double* sums) noexcept;
  /// For every m: ratios of squared distances to the smallest one, raised to 1 / (m - 1). Never 0/0, never overflows.
  void (*ratios)(const FcmBlock& block, const FcmPlace& place, double* sums) noexcept;
};

/// The sets that this processor can run, the fastest last.
std::span<const FcmKernels> supportedFcmKernels() noexcept;

}  // namespace tactus::elicitation
