#include "elicitation/fcm_descent.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "elicitation/fcm_pass.h"

namespace tactus::elicitation {
namespace {

// J of two neighbouring points differs by rounding alone below this share.
constexpr double kObjectiveNoise = 1e-13;

/// Solves matrix * x = right by Cholesky's method; false where the matrix is not positive definite.
bool solvePositive(std::vector<double> matrix, std::vector<double>& right) {
  const std::size_t n = right.size();
  for (std::size_t j = 0; j < n; ++j) {
    double pivot = matrix[j * n + j];
    const double before = pivot;
    for (std::size_t k = 0; k < j; ++k) pivot -= matrix[j * n + k] * matrix[j * n + k];
    if (!(pivot > 1e-14 * before)) return false;
    const double root = std::sqrt(pivot);
    matrix[j * n + j] = root;
    for (std::size_t i = j + 1; i < n; ++i) {
      double sum = matrix[i * n + j];
      for (std::size_t k = 0; k < j; ++k) sum -= matrix[i * n + k] * matrix[j * n + k];
      matrix[i * n + j] = sum / root;
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) right[i] -= matrix[i * n + k] * right[k];
    right[i] /= matrix[i * n + i];
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) right[i] -= matrix[k * n + i] * right[k];
    right[i] /= matrix[i * n + i];
  }
  return true;
}

std::vector<double> moved(const std::vector<double>& centres, const std::vector<double>& step) {
  std::vector<double> out = centres;
  for (std::size_t k = 0; k < out.size(); ++k) out[k] += step[k];
  return out;
}

double largest(const std::vector<double>& step) {
  double most = 0;
  for (const double s : step) most = std::max(most, std::abs(s));
  return most;
}

/// A Newton step may not carry centres out of the data or past each other: it would leave its own valley.
bool inOrder(const std::vector<double>& centres, const WeightedValues& data) {
  return centres.front() >= data.values.front() && centres.back() <= data.values.back() &&
         std::adjacent_find(centres.begin(), centres.end(), std::greater_equal<>()) == centres.end();
}

/// The step of Bezdek's iteration: each centre to the mean of the values weighted by u^m.
std::vector<double> meanStep(const FcmSums& sums) {
  std::vector<double> step(sums.pull.size());
  for (std::size_t k = 0; k < step.size(); ++k) step[k] = sums.weight[k] > 0 ? sums.pull[k] / sums.weight[k] : 0.0;
  return step;
}

}  // namespace

FcmDescent descend(const WeightedValues& data, std::vector<double> centres, double range, int warm_up,
                   const FcmSettings& settings) {
  FcmPass pass(centres.size(), settings.m);
  FcmSums sums;
  FcmSums next;
  pass.run(data, centres, sums);

  FcmDescent out;
  const double small = settings.tolerance * range;
  while (out.iterations < settings.most_iterations && !out.converged) {
    ++out.iterations;
    std::vector<double> step = sums.pull;
    out.minimum = solvePositive(sums.curvature, step);
    std::vector<double> candidate;
    if (out.minimum && out.iterations > warm_up) {
      candidate = moved(centres, step);
      if (inOrder(candidate, data)) {
        pass.run(data, candidate, next);
        if (next.objective > sums.objective * (1 + kObjectiveNoise)) candidate.clear();
      } else {
        candidate.clear();
      }
    }
    if (candidate.empty()) {
      step = meanStep(sums);
      candidate = moved(centres, step);
      pass.run(data, candidate, next);
    }
    out.converged = largest(step) <= small;
    centres = std::move(candidate);
    std::swap(sums, next);
  }
  std::sort(centres.begin(), centres.end());
  out.centres = std::move(centres);
  out.objective = sums.objective;
  return out;
}

}  // namespace tactus::elicitation
