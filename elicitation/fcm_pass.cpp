#include "elicitation/fcm_pass.h"

#include <algorithm>
#include <cmath>

namespace tactus::elicitation {
namespace {

// Samples added up plainly before compensation; short enough that their rounding stays below the result's.
constexpr std::size_t kBlock = 256;
// Below this, products of squared distances lose digits to underflow.
constexpr double kSmallestProduct = 1e-250;

}  // namespace

FcmPass::FcmPass(std::size_t clusters, double m)
    : clusters_(clusters),
      m_(m),
      p_(1 / (m - 1)),
      squares_(clusters),
      powers_(clusters),
      ahead_(clusters),
      block_(2 * clusters + clusters * clusters + 1),
      total_(block_.size()),
      rounding_(block_.size()) {}

void FcmPass::run(const WeightedValues& data, std::span<const double> centres, FcmSums& sums) {
  std::fill(total_.begin(), total_.end(), 0.0);
  std::fill(rounding_.begin(), rounding_.end(), 0.0);
  for (std::size_t begin = 0; begin < data.values.size(); begin += kBlock) {
    const std::size_t end = std::min(begin + kBlock, data.values.size());
    std::fill(block_.begin(), block_.end(), 0.0);
    for (std::size_t i = begin; i < end; ++i) {
      addToBlock(data.values[i], data.weights.empty() ? 1.0 : data.weights[i], centres);
    }
    for (std::size_t j = 0; j < block_.size(); ++j) {
      const double sum = total_[j] + block_[j];
      rounding_[j] +=
          std::abs(total_[j]) >= std::abs(block_[j]) ? (total_[j] - sum) + block_[j] : (block_[j] - sum) + total_[j];
      total_[j] = sum;
    }
  }
  for (std::size_t j = 0; j < total_.size(); ++j) total_[j] += rounding_[j];

  const std::size_t c = clusters_;
  sums.weight.assign(total_.begin(), total_.begin() + static_cast<std::ptrdiff_t>(c));
  sums.pull.assign(total_.begin() + static_cast<std::ptrdiff_t>(c),
                   total_.begin() + static_cast<std::ptrdiff_t>(2 * c));
  sums.objective = total_.back();
  sums.curvature.resize(c * c);
  for (std::size_t k = 0; k < c; ++k) {
    for (std::size_t l = 0; l <= k; ++l) {
      double value = 2 * m_ * p_ * total_[2 * c + k * c + l];
      if (k == l) value -= (m_ + 1) * p_ * total_[k];
      sums.curvature[k * c + l] = sums.curvature[l * c + k] = value;
    }
  }
}

void FcmPass::addToBlock(double x, double weight, std::span<const double> centres) {
  const std::size_t c = clusters_;
  for (std::size_t k = 0; k < c; ++k) squares_[k] = (x - centres[k]) * (x - centres[k]);
  const double h = m_ == 2 ? productForm() : ratioForm();

  double* const sum_weight = block_.data();
  double* const sum_pull = sum_weight + c;
  double* const sum_outer = sum_pull + c;
  block_.back() += weight * h;
  for (std::size_t k = 0; k < c; ++k) {
    sum_weight[k] += weight * powers_[k];
    powers_[k] *= x - centres[k];  // from here u^m d
    sum_pull[k] += weight * powers_[k];
  }
  // On a centre every u^m d is 0, and so is its share of the curvature.
  if (h < kSmallestProduct) return;
  const double factor = weight / h;
  for (std::size_t k = 0; k < c; ++k) {
    const double scaled = factor * powers_[k];
    for (std::size_t l = 0; l <= k; ++l) sum_outer[k * c + l] += scaled * powers_[l];
  }
}

double FcmPass::productForm() {
  // m = 2: u_k is the product of the squares of the others by the sum of such products, so nothing is divided by 0.
  const std::size_t c = clusters_;
  double product = 1;
  for (std::size_t k = 0; k < c; ++k) {
    ahead_[k] = product;
    product *= squares_[k];
  }
  const double all = product;
  double sum = 0;
  product = 1;
  for (std::size_t k = c; k-- > 0;) {
    powers_[k] = ahead_[k] * product;
    product *= squares_[k];
    sum += powers_[k];
  }
  if (sum < kSmallestProduct) return ratioForm();
  const double scale = 1 / sum;
  for (std::size_t k = 0; k < c; ++k) {
    const double u = powers_[k] * scale;
    powers_[k] = u * u;
  }
  return all * scale;
}

double FcmPass::ratioForm() {
  // u_k^m = r_k^m / S^m with r_k = (q_min / q_k)^p, S their sum, and r_k^m = r_k q_min / q_k.
  const double nearest = *std::min_element(squares_.begin(), squares_.end());
  double sum = 0;
  for (std::size_t k = 0; k < clusters_; ++k) {
    const double ratio = squares_[k] == nearest ? 1.0 : nearest / squares_[k];
    const double r = ratio == 1 ? 1.0 : std::pow(ratio, p_);
    sum += r;
    powers_[k] = r * ratio;
  }
  const double scale = std::pow(sum, -m_);
  for (double& power : powers_) power *= scale;
  return nearest * sum * scale;
}

}  // namespace tactus::elicitation
