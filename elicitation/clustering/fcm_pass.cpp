#include "elicitation/clustering/fcm_pass.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tactus::elicitation {
namespace {

// Samples added up plainly, kFcmMostRows in each lane, before compensation: their rounding stays below the result's.
constexpr std::size_t kBlock = kFcmMostRows * kFcmLanes;

double sumOfLanes(const double* lane) {
  return ((lane[0] + lane[4]) + (lane[2] + lane[6])) + ((lane[1] + lane[5]) + (lane[3] + lane[7]));
}

}  // namespace

FcmPass::FcmPass(std::size_t clusters, double m) : FcmPass(clusters, m, supportedFcmKernels().back()) {}

FcmPass::FcmPass(std::size_t clusters, double m, const FcmKernels& kernels)
    : clusters_(clusters),
      m_(m),
      kernels_(kernels),
      lanes_(fcmSumCount(clusters) * kFcmLanes),
      total_(fcmSumCount(clusters)),
      rounding_(total_.size()) {}

void FcmPass::run(const FcmData& data, std::span<const double> centres, FcmSums& sums) {
  std::fill(total_.begin(), total_.end(), 0.0);
  std::fill(rounding_.begin(), rounding_.end(), 0.0);
  FcmBlock block{nullptr, nullptr, 0, data.scale, data.shift, data.stretch, data.weight_scale};
  const std::size_t whole = data.values.size() / kFcmLanes * kFcmLanes;
  for (std::size_t begin = 0; begin < whole; begin += kBlock) {
    block.values = data.values.data() + begin;
    block.weights = data.weights.empty() ? nullptr : data.weights.data() + begin;
    block.count = std::min(kBlock, whole - begin);
    addBlock(block, centres);
  }
  if (whole < data.values.size()) addTail(data, whole, block, centres);
  for (std::size_t j = 0; j < total_.size(); ++j) total_[j] += rounding_[j];
  finish(sums);
}

void FcmPass::addTail(const FcmData& data, std::size_t begin, FcmBlock block, std::span<const double> centres) {
  std::array<double, kFcmLanes> values;
  values.fill(data.values.back());
  std::array<double, kFcmLanes> weights{};
  for (std::size_t i = begin; i < data.values.size(); ++i) {
    values[i - begin] = data.values[i];
    weights[i - begin] = data.weight(i);
  }
  block.values = values.data();
  block.weights = weights.data();
  block.weight_scale = 1;
  block.count = kFcmLanes;
  addBlock(block, centres);
}

void FcmPass::addBlock(const FcmBlock& block, std::span<const double> centres) {
  const FcmPlace place{centres.data(), clusters_, m_};
  if (m_ != 2 || !kernels_.products(block, place, lanes_.data())) kernels_.ratios(block, place, lanes_.data());
  for (std::size_t j = 0; j < total_.size(); ++j) {
    const double added = sumOfLanes(lanes_.data() + j * kFcmLanes);
    const double sum = total_[j] + added;
    rounding_[j] += std::abs(total_[j]) >= std::abs(added) ? (total_[j] - sum) + added : (added - sum) + total_[j];
    total_[j] = sum;
  }
}

void FcmPass::finish(FcmSums& sums) const {
  const std::size_t c = clusters_;
  const double p = 1 / (m_ - 1);
  const auto pull = total_.begin() + static_cast<std::ptrdiff_t>(c);
  const auto outer = pull + static_cast<std::ptrdiff_t>(c);
  sums.weight.assign(total_.begin(), pull);
  sums.pull.assign(pull, outer);
  sums.objective = total_.back();
  sums.curvature.resize(c * c);
  auto product = outer;
  for (std::size_t k = 0; k < c; ++k) {
    for (std::size_t l = 0; l <= k; ++l) {
      double value = 2 * m_ * p * *product++;
      if (k == l) value -= (m_ + 1) * p * sums.weight[k];
      sums.curvature[k * c + l] = sums.curvature[l * c + k] = value;
    }
  }
}

}  // namespace tactus::elicitation
