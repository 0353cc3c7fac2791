#include "experiments/smooth_motion.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/check.h"
#include "core/base/statistics.h"
#include "experiments/motion_likelihood.h"

namespace tactus::experiments {
namespace {

constexpr double kLowestHz = 7;
constexpr double kStepHz = 0.5;
constexpr std::size_t kFrequencies = 13;
constexpr double kLeastNoiseMm = 0.005;
// Starts: movements without detail below these widths; powers of their roughness, 0 = equally rough everywhere.
constexpr std::array kPilotsS = {0.04, 0.02};
constexpr std::array kPilotPowers = {0.0, 1.0, 2.0};
constexpr int kRounds = 5;

/// Derivatives of splineValues by u.
std::array<double, kSplineOrder> splineSlopes(double u) {
  const double v = 1 - u;
  return {-v * v / 2, (3 * u * u - 4 * u) / 2, (4 * v - 3 * v * v) / 2, u * u / 2};
}

/// Standard deviation of the noise of each position, from third differences; a movement hardly shows in their median.
double noiseMm(std::span<const double> y) {
  std::vector<double> sizes;
  for (std::size_t i = 3; i < y.size(); ++i) {
    sizes.push_back(std::abs(y[i] - 3 * y[i - 1] + 3 * y[i - 2] - y[i - 3]));
  }
  constexpr double kMedianToDeviation = 1.4826;  // of a normal distribution
  return std::max(kLeastNoiseMm, kMedianToDeviation * base::median(std::move(sizes)) / std::sqrt(20.0));
}

/// The positions at the knots without tremor and without detail: straight lines through weighted neighbors.
std::vector<double> pilotAtKnots(std::span<const double> y, double step_s, std::size_t knots, double pilot_s) {
  std::vector<double> pilot(knots);
  for (std::size_t knot = 0; knot < knots; ++knot) {
    const double centre_s = (static_cast<double>(knot) - 1) * kKnotS;
    double w0 = 0, w1 = 0, w2 = 0, v0 = 0, v1 = 0;
    for (std::size_t i = 0; i < y.size(); ++i) {
      const double away_s = static_cast<double>(i) * step_s - centre_s;
      const double weight = std::exp(-away_s * away_s / (2 * pilot_s * pilot_s));
      w0 += weight;
      w1 += weight * away_s;
      w2 += weight * away_s * away_s;
      v0 += weight * y[i];
      v1 += weight * away_s * y[i];
    }
    pilot[knot] = (w2 * v0 - w1 * v1) / (w0 * w2 - w1 * w1);
  }
  return pilot;
}

}  // namespace

SmoothMotion::SmoothMotion(std::span<const double> y, double step_s)
    : knot_s_(kKnotS), length_s_(static_cast<double>(y.size() - 1) * step_s), offset_mm_(y[y.size() / 2]) {
  TACTUS_CHECK(y.size() >= kFewestPositions && step_s > 0);
  const auto spans = static_cast<std::size_t>(std::ceil(length_s_ / kKnotS - 1e-9));
  const std::size_t spline_count = spans + kSplineOrder - 1;
  const double noise_mm = noiseMm(y);

  std::array<double, kFrequencies> hz{};
  for (std::size_t i = 0; i < hz.size(); ++i) hz[i] = kLowestHz + static_cast<double>(i) * kStepHz;
  const MotionEquations equations(y, step_s, offset_mm_, hz, spline_count, noise_mm);
  // From one start the rounds may end where tremor and movement are mixed up; the likelihood tells.
  MotionFit best;
  for (const double pilot_s : kPilotsS) {
    const auto pilot = roughness(pilotAtKnots(y, step_s, spline_count, pilot_s));
    for (const double power : kPilotPowers) {
      std::vector<double> rough = pilot;
      for (double& value : rough) value = std::pow(value, power);
      MotionFit fit = likeliestMotion(equations, rough);
      for (int round = 1; round < kRounds && !fit.coefficients.empty(); ++round) {
        fit = likeliestMotion(equations, roughness(fit.coefficients), &fit);
      }
      if (fit.unlikelihood < best.unlikelihood) best = std::move(fit);
    }
  }
  coefficients_ = std::move(best.coefficients);
  TACTUS_CHECK(coefficients_.size() == spline_count);
}

double SmoothMotion::speedMmS(double time_s) const {
  const double place = std::clamp(time_s, 0.0, length_s_) / knot_s_;
  const auto knot = std::min(static_cast<std::size_t>(place), coefficients_.size() - kSplineOrder);
  const auto slopes = splineSlopes(place - static_cast<double>(knot));
  double speed = 0;
  for (std::size_t k = 0; k < kSplineOrder; ++k) speed += slopes[k] * coefficients_[knot + k];
  return speed / knot_s_;
}

double SmoothMotion::positionMm(double time_s) const {
  const double place = std::clamp(time_s, 0.0, length_s_) / knot_s_;
  const auto knot = std::min(static_cast<std::size_t>(place), coefficients_.size() - kSplineOrder);
  const auto values = splineValues(place - static_cast<double>(knot));
  double position = offset_mm_;
  for (std::size_t k = 0; k < kSplineOrder; ++k) position += values[k] * coefficients_[knot + k];
  return position;
}

}  // namespace tactus::experiments
