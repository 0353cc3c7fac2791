#include <algorithm>
#include <cmath>
#include <numbers>

#include "experiments/stroke_segmentation.h"

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
void penalize(BandMatrix<kSplineOrder>& matrix, std::span<const double> penalties) {
  for (std::size_t start = 0; start < penalties.size(); ++start) {
    for (std::size_t r = 0; r < kThird.size(); ++r) {
      for (std::size_t c = 0; c <= r; ++c) matrix.at(start + r, start + c) += penalties[start] * kThird[r] * kThird[c];
    }
  }
}

template <std::size_t Columns>
double squaresOf(std::span<const std::array<double, Columns>> rows) {
  double sum = 0;
  for (const auto& row : rows) {
    for (const double value : row) sum += value * value;
  }
  return sum;
}

/// The tremor's equations without what the splines explain: with L Lᵀ = splines, W = L⁻¹ with_splines and
/// z = L⁻¹ right, the matrix is among - Wᵀ W, the right side is right - Wᵀ z.
struct TremorAlone {
  std::vector<TremorRow> w;
  BandMatrix<kTremorColumns> matrix;
  std::vector<std::array<double, 1>> right;

  TremorAlone(const TremorEquations& tremor, const BandMatrix<kSplineOrder>& splines,
              std::span<const std::array<double, 1>> z)
      : w(tremor.with_splines), matrix(tremor.among), right(kTremorColumns) {
    splines.forward(std::span(w));
    std::array<TremorRow, kTremorColumns> products{};
    TremorRow with_z{};
    for (std::size_t i = 0; i < w.size(); ++i) {
      for (std::size_t r = 0; r < kTremorColumns; ++r) {
        for (std::size_t c = 0; c < kTremorColumns; ++c) products[r][c] += w[i][r] * w[i][c];
        with_z[r] += w[i][r] * z[i][0];
      }
    }
    for (std::size_t r = 0; r < kTremorColumns; ++r) {
      for (std::size_t c = 0; c <= r; ++c) matrix.at(r, c) -= products[r][c];
      right[r][0] = tremor.right[r] - with_z[r];
    }
  }
};

/// The solution for the splines from the halves that `likeliestMotion` has: the tremor's first, then the splines'.
std::vector<double> splineCoefficients(const BandMatrix<kSplineOrder>& splines, std::vector<std::array<double, 1>> z,
                                       TremorAlone tremor) {
  tremor.matrix.backward(std::span(tremor.right));
  for (std::size_t i = 0; i < z.size(); ++i) {
    for (std::size_t c = 0; c < kTremorColumns; ++c) z[i][0] -= tremor.w[i][c] * tremor.right[c][0];
  }
  splines.backward(std::span(z));
  std::vector<double> coefficients;
  coefficients.reserve(z.size());
  for (const auto& row : z) coefficients.push_back(row[0]);
  return coefficients;
}

}  // namespace

std::array<double, kSplineOrder> splineValues(double u) {
  const double v = 1 - u;
  return {v * v * v / 6, (3 * u * u * u - 6 * u * u + 4) / 6, (3 * v * v * v - 6 * v * v + 4) / 6, u * u * u / 6};
}

MotionEquations::MotionEquations(std::span<const double> y, double step_s, double offset_mm, std::span<const double> hz,
                                 std::size_t spline_count, double noise_mm)
    : splines(spline_count), right(spline_count), tremors(hz.size()), positions(static_cast<double>(y.size())) {
  for (TremorEquations& tremor : tremors) tremor.with_splines.resize(spline_count);
  const double middle = static_cast<double>(y.size() - 1) / 2;
  for (std::size_t i = 0; i < y.size(); ++i) {
    const double place = static_cast<double>(i) * step_s / kKnotS;
    const auto knot = std::min(static_cast<std::size_t>(place), spline_count - kSplineOrder);
    const auto spline = splineValues(place - static_cast<double>(knot));
    const double value = y[i] - offset_mm;
    squares_mm2 += value * value;
    for (std::size_t r = 0; r < kSplineOrder; ++r) {
      right[knot + r][0] += spline[r] * value;
      for (std::size_t c = 0; c <= r; ++c) splines.at(knot + r, knot + c) += spline[r] * spline[c];
    }
    const double drift = (static_cast<double>(i) - middle) / middle;
    for (std::size_t f = 0; f < hz.size(); ++f) {
      const double phase = 2 * std::numbers::pi * hz[f] * step_s * static_cast<double>(i);
      const double sine = std::sin(phase);
      const double cosine = std::cos(phase);
      const TremorRow row = {sine, cosine, drift * sine, drift * cosine};
      TremorEquations& tremor = tremors[f];
      for (std::size_t r = 0; r < kTremorColumns; ++r) {
        tremor.right[r] += row[r] * value;
        for (std::size_t k = 0; k < kSplineOrder; ++k) tremor.with_splines[knot + k][r] += row[r] * spline[k];
        for (std::size_t c = 0; c <= r; ++c) tremor.among.at(r, c) += row[r] * row[c];
      }
    }
  }
  for (TremorEquations& tremor : tremors) {
    for (std::size_t k = 0; k < kTremorColumns; ++k) {
      const double usual_mm = k < 2 ? kTremorMm : kTremorDriftMm;
      tremor.among.at(k, k) += noise_mm * noise_mm / (usual_mm * usual_mm);
    }
  }
}

MotionFit likeliestMotion(const MotionEquations& equations, std::span<const double> rough, const MotionFit* near) {
  std::size_t from = 0;
  std::size_t to = equations.tremors.size();
  int least_penalty = kLeastPenalty;
  int most_penalty = kMostPenalty;
  if (near != nullptr) {
    from = near->frequency - std::min(near->frequency, kNearFrequencies);
    to = std::min(to, near->frequency + kNearFrequencies + 1);
    least_penalty = std::max(least_penalty, near->penalty - kNearPenalties);
    most_penalty = std::min(most_penalty, near->penalty + kNearPenalties);
  }
  MotionFit best;
  double log_rough = 0;
  for (const double value : rough) log_rough += std::log(value);
  std::vector<double> penalties(rough.size());
  for (int exponent = least_penalty; exponent <= most_penalty; ++exponent) {
    const double penalty = std::pow(10.0, exponent);
    for (std::size_t i = 0; i < rough.size(); ++i) penalties[i] = penalty / rough[i];
    BandMatrix<kSplineOrder> splines = equations.splines;
    penalize(splines, penalties);
    const double log_splines = splines.factorize();
    if (!std::isfinite(log_splines)) continue;
    auto z = equations.right;
    splines.forward(std::span(z));
    const double explained_by_splines = squaresOf(std::span<const std::array<double, 1>>(z));
    const double log_penalties = static_cast<double>(rough.size()) * std::log(penalty) - log_rough;
    for (std::size_t frequency = from; frequency < to; ++frequency) {
      TremorAlone tremor(equations.tremors[frequency], splines, z);
      const double log_tremor = tremor.matrix.factorize();
      if (!std::isfinite(log_tremor)) continue;
      tremor.matrix.forward(std::span(tremor.right));
      const double explained = explained_by_splines + squaresOf(std::span<const std::array<double, 1>>(tremor.right));
      const double misfit = std::max(equations.squares_mm2 - explained, kLeastMisfitMm2 * equations.positions);
      // Third differences leave a parabola free: it is not random in the restricted likelihood.
      const double unlikelihood =
          (equations.positions - 3) * std::log(misfit) + log_splines + log_tremor - log_penalties;
      if (unlikelihood >= best.unlikelihood) continue;
      best = {unlikelihood, frequency, exponent, splineCoefficients(splines, z, std::move(tremor))};
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
