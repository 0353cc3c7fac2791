#include "tests/reference/fcm_reference.h"

#include <algorithm>
#include <cmath>

namespace tactus::reference {
namespace {

long double weightOf(const FcmProblem& problem, std::size_t i) {
  return problem.weights.empty() ? 1 : problem.weights[i];
}

/// base^exponent for base in [0, 1], to about 1e-18 of the result times its logarithm: std::pow takes ten times as
/// long.
long double power(long double base, long double exponent) {
  if (exponent == 1) return base;
  if (exponent == 2) return base * base;
  return std::exp2(exponent * std::log2(base));
}

void memberships(long double x, std::span<const long double> centres, double m, std::vector<long double>& u) {
  const std::size_t c = centres.size();
  long double nearest = std::abs(x - centres[0]);
  for (const long double centre : centres) nearest = std::min(nearest, std::abs(x - centre));
  // Fractions by the nearest distance: nothing overflows, and a centre on x takes all.
  long double sum = 0;
  for (std::size_t k = 0; k < c; ++k) {
    const long double distance = std::abs(x - centres[k]);
    u[k] = distance == nearest ? 1 : power(nearest / distance, 2 / (static_cast<long double>(m) - 1));
    sum += u[k];
  }
  for (long double& value : u) value /= sum;
}

}  // namespace

std::vector<long double> fcmMemberships(long double x, std::span<const long double> centres, double m) {
  std::vector<long double> u(centres.size());
  memberships(x, centres, m, u);
  return u;
}

long double fcmObjective(const FcmProblem& problem, std::span<const long double> centres) {
  std::vector<long double> u(centres.size());
  long double objective = 0;
  for (std::size_t i = 0; i < problem.samples.size(); ++i) {
    memberships(problem.samples[i], centres, problem.m, u);
    for (std::size_t k = 0; k < centres.size(); ++k) {
      const long double distance = problem.samples[i] - centres[k];
      objective += weightOf(problem, i) * power(u[k], problem.m) * distance * distance;
    }
  }
  return objective;
}

FcmFixedPoint fcmFixedPoint(const FcmProblem& problem, std::vector<long double> centres, int most) {
  const auto [low, high] = std::minmax_element(problem.samples.begin(), problem.samples.end());
  const long double still = 1e-18L * (static_cast<long double>(*high) - *low);
  const std::size_t c = centres.size();
  std::vector<long double> u(c);
  FcmFixedPoint out;
  while (out.iterations < most && !out.stands_still) {
    ++out.iterations;
    std::vector<long double> weight(c, 0);
    std::vector<long double> pull(c, 0);  // deviations from the present centre keep digits under a large offset
    for (std::size_t i = 0; i < problem.samples.size(); ++i) {
      memberships(problem.samples[i], centres, problem.m, u);
      for (std::size_t k = 0; k < c; ++k) {
        const long double share = weightOf(problem, i) * power(u[k], problem.m);
        weight[k] += share;
        pull[k] += share * (problem.samples[i] - centres[k]);
      }
    }
    long double change = 0;
    for (std::size_t k = 0; k < c; ++k) {
      const long double step = weight[k] > 0 ? pull[k] / weight[k] : 0;
      centres[k] += step;
      change = std::max(change, std::abs(step));
    }
    out.stands_still = change <= still;
  }
  std::sort(centres.begin(), centres.end());
  out.centres = std::move(centres);
  return out;
}

}  // namespace tactus::reference
