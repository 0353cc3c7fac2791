// One pass over the data: everything that a step of the descent needs (part of fcm.h).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "elicitation/fcm_samples.h"

namespace tactus::elicitation {

/// Sums over the samples at fixed centres, with u the memberships and d_k = x - v_k.
struct FcmSums {
  std::vector<double> weight;  ///< of u_k^m
  std::vector<double> pull;    ///< of u_k^m d_k: half the descent direction of J
  /// Half of J's second derivatives by the centres, c by c, row by row. With h = sum of u_k^m d_k^2 of one sample it is
  /// -(m + 1)/(m - 1) diag(weight) + 2m/(m - 1) sum of (u_k^m d_k)(u_l^m d_l)/h.
  std::vector<double> curvature;
  double objective = 0;  ///< J
};

/// Scratch and formulas for one c and m. Memory O(c^2).
class FcmPass {
 public:
  FcmPass(std::size_t clusters, double m);

  /// The sums at `centres`. Values in [-1, 1]; centres may coincide with values and with each other.
  void run(const WeightedValues& data, std::span<const double> centres, FcmSums& sums);

 private:
  /// u^m of one value from the squares_ of its distances, into powers_; returns h.
  double productForm();
  double ratioForm();
  void addToBlock(double x, double weight, std::span<const double> centres);

  std::size_t clusters_;
  double m_;
  double p_;  // 1 / (m - 1)
  std::vector<double> squares_, powers_, ahead_;
  std::vector<double> block_;     // sums of one block: weight, pull, outer products, J
  std::vector<double> total_;     // sums of all blocks
  std::vector<double> rounding_;  // what the additions to total_ lost (Neumaier 1974)
};

}  // namespace tactus::elicitation
