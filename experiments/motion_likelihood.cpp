#include "experiments/motion_likelihood.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tactus::experiments {
namespace {

// Exponents of 10 of the penalty of squared third differences, per squared millimeter of misfit.
constexpr int kLeastPenalty = -2;
constexpr int kMostPenalty = 7;
constexpr std::size_t kNearFrequencies = 2;
constexpr int kNearPenalties = 2;
constexpr double kTremorMm = 0.2;         // usual amplitude of tremor
constexpr double kTremorDriftMm = 0.06;   // and of its change within the stretch
constexpr double kLeastMisfitMm2 = 1e-9;  // simulated hands may be exact; real positions are rounded to counts
constexpr std::size_t kAround = 2;        // neighbors (24 ms) on each side that roughness is averaged over
constexpr double kLeastRoughness = 1e-4;
constexpr std::array<double, 4> kThird = {-1, 3, -3, 1};

/// Adds the squared third differences of the spline's coefficients, each times its penalty.
void penalize(BorderedMatrix& matrix, std::span<const double> penalties) {
  for (std::size_t start = 0; start < penalties.size(); ++start) {
    for (std::size_t r = 0; r < kThird.size(); ++r) {
      for (std::size_t c = 0; c <= r; ++c) matrix.at(start + r, start + c) += penalties[start] * kThird[r] * kThird[c];
    }
  }
}

}  // namespace

std::array<double, kSplineOrder> splineValues(double u) {
  const double v = 1 - u;
  return {v * v * v / 6, (3 * u * u * u - 6 * u * u + 4) / 6, (3 * v * v * v - 6 * v * v + 4) / 6, u * u * u / 6};
}

MotionEquations::MotionEquations(std::span<const double> y, double step_s, double offset_mm, double hz,
                                 std::size_t spline_count, double noise_mm)
    : matrix(spline_count + kTremorColumns, kSplineOrder, kTremorColumns),
      right(spline_count + kTremorColumns),
      positions(static_cast<double>(y.size())) {
  const double middle = static_cast<double>(y.size() - 1) / 2;
  for (std::size_t i = 0; i < y.size(); ++i) {
    const double place = static_cast<double>(i) * step_s / kKnotS;
    const auto knot = std::min(static_cast<std::size_t>(place), spline_count - kSplineOrder);
    const double phase = 2 * std::numbers::pi * hz * step_s * static_cast<double>(i);
    const double drift = (static_cast<double>(i) - middle) / middle;
    const auto b = splineValues(place - static_cast<double>(knot));
    const std::array<double, kSplineOrder + kTremorColumns> row = {
        b[0], b[1], b[2], b[3], std::sin(phase), std::cos(phase), drift * std::sin(phase), drift * std::cos(phase)};
    std::array<std::size_t, kSplineOrder + kTremorColumns> column{};
    for (std::size_t k = 0; k < kSplineOrder; ++k) column[k] = knot + k;
    for (std::size_t k = 0; k < kTremorColumns; ++k) column[kSplineOrder + k] = spline_count + k;
    const double value = y[i] - offset_mm;
    squares_mm2 += value * value;
    for (std::size_t r = 0; r < row.size(); ++r) {
      right[column[r]] += row[r] * value;
      for (std::size_t c = 0; c <= r; ++c) matrix.at(column[r], column[c]) += row[r] * row[c];
    }
  }
  for (std::size_t k = 0; k < kTremorColumns; ++k) {
    const double usual_mm = k < 2 ? kTremorMm : kTremorDriftMm;
    matrix.at(spline_count + k, spline_count + k) += noise_mm * noise_mm / (usual_mm * usual_mm);
  }
}

MotionFit likeliestMotion(std::span<const MotionEquations> equations, std::span<const double> rough,
                          const MotionFit* near) {
  std::size_t from = 0;
  std::size_t to = equations.size();
  int least_penalty = kLeastPenalty;
  int most_penalty = kMostPenalty;
  if (near != nullptr) {
    from = near->equations - std::min(near->equations, kNearFrequencies);
    to = std::min(to, near->equations + kNearFrequencies + 1);
    least_penalty = std::max(least_penalty, near->penalty - kNearPenalties);
    most_penalty = std::min(most_penalty, near->penalty + kNearPenalties);
  }
  MotionFit best;
  double log_rough = 0;
  for (const double value : rough) log_rough += std::log(value);
  std::vector<double> penalties(rough.size());
  const std::size_t spline_count = rough.size() + 3;
  for (std::size_t equation = from; equation < to; ++equation) {
    const auto& [matrix, right, squares_mm2, positions] = equations[equation];
    for (int exponent = least_penalty; exponent <= most_penalty; ++exponent) {
      const double penalty = std::pow(10.0, exponent);
      for (std::size_t i = 0; i < rough.size(); ++i) penalties[i] = penalty / rough[i];
      BorderedMatrix penalized = matrix;
      penalize(penalized, penalties);
      const double log_determinant = penalized.factorize();
      if (!std::isfinite(log_determinant)) continue;
      auto solution = penalized.solve(right);
      double misfit = squares_mm2;
      for (std::size_t k = 0; k < solution.size(); ++k) misfit -= solution[k] * right[k];
      misfit = std::max(misfit, kLeastMisfitMm2 * positions);
      const double log_penalties = static_cast<double>(rough.size()) * std::log(penalty) - log_rough;
      // Third differences leave a parabola free: it is not random in the restricted likelihood.
      const double unlikelihood = (positions - 3) * std::log(misfit) + log_determinant - log_penalties;
      if (unlikelihood >= best.unlikelihood) continue;
      solution.resize(spline_count);
      best = {unlikelihood, equation, exponent, std::move(solution)};
    }
  }
  return best;
}

std::vector<double> roughness(std::span<const double> coefficients) {
  const std::size_t count = coefficients.size() - 3;
  std::vector<double> squares(count);
  for (std::size_t start = 0; start < count; ++start) {
    double difference = 0;
    for (std::size_t k = 0; k < kThird.size(); ++k) difference += kThird[k] * coefficients[start + k];
    squares[start] = difference * difference;
  }
  std::vector<double> around(count);
  double total = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t from = i < kAround ? 0 : i - kAround;
    const std::size_t to = std::min(count, i + kAround + 1);
    for (std::size_t k = from; k < to; ++k) around[i] += squares[k] / static_cast<double>(to - from);
    total += around[i] / static_cast<double>(count);
  }
  for (double& value : around) value = std::max(total > 0 ? value / total : 1, kLeastRoughness);
  return around;
}

}  // namespace tactus::experiments
