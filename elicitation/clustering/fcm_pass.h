// One pass over the data: all sums for a step of the descent (part of fcm.h).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "elicitation/clustering/fcm_data.h"
#include "elicitation/clustering/fcm_kernels.h"

namespace tactus::elicitation {

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
