#include "core/haptics/device/velocity_estimator.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

namespace tactus::haptics {
namespace {

constexpr double kTickS = 0.001;
constexpr double kWide = 1e9;  ///< a bound that every window keeps

using Adaptive = AdaptiveWindowVelocity;
using Line = AdaptiveWindowVelocity::Line;

/// The speeds for positions at 1 kHz.
template <typename Estimator, typename Position>
std::vector<double> speeds(Estimator estimator, int ticks, Position position) {
  std::vector<double> out;
  for (int i = 0; i < ticks; ++i) out.push_back(estimator.next(position(i * kTickS), kTickS));
  return out;
}

double counted(double position_mm) { return 0.055 * std::round(position_mm / 0.055); }

/// Pole of the one-pole low-pass: exp(-x) as 1/(1 + x + x²/2 + x³/6), x = 2 pi 25 Hz 1 ms.
double pole() {
  const double x = 2 * std::numbers::pi * 25 * kTickS;
  return 1 / (1 + x + x * x / 2 + x * x * x / 6);
}

TEST(VelocityEstimators, ConstantSpeedIsFoundExactly) {
  const auto ramp = [](double time_s) { return 3 + 80 * time_s; };
  EXPECT_NEAR(speeds(DifferenceVelocity(), 100, ramp).back(), 80, 1e-9);
  EXPECT_NEAR(speeds(LowPassVelocity(), 1000, ramp).back(), 80, 1e-9);
  for (const Line line : {Line::kEndFit, Line::kBestFit}) {
    const auto seen = speeds(Adaptive(line), 100, ramp);
    EXPECT_EQ(seen[0], 0);
    for (std::size_t i = 1; i < seen.size(); ++i) ASSERT_NEAR(seen[i], 80, 1e-9);
  }
}

TEST(VelocityEstimators, LagOnAcceleratedMotionIsTheKnownOne) {
  // x = a t²/2, v = a t: a lag of L reads a (t - L). A line through a parabola has the slope of the middle.
  const double a = 700;
  const auto parabola = [=](double time_s) { return a * time_s * time_s / 2; };
  const double end_s = 0.999;
  const auto lag = [=](const std::vector<double>& seen) { return end_s - seen.back() / a; };
  EXPECT_NEAR(lag(speeds(DifferenceVelocity(), 1000, parabola)), kTickS / 2, 1e-9);
  // Each stage lags by p/(1-p) ticks.
  const double stage_s = kTickS * pole() / (1 - pole());
  EXPECT_NEAR(lag(speeds(LowPassVelocity(), 1000, parabola)), 2 * stage_s + kTickS / 2, 1e-9);
  EXPECT_NEAR(2 * stage_s + kTickS / 2, 0.0123, 0.00005) << "as the header says";
  for (const Line line : {Line::kEndFit, Line::kBestFit})
    for (const int window : {1, 4, 15})
      EXPECT_NEAR(lag(speeds(Adaptive(line, kWide, window), 1000, parabola)), window * kTickS / 2, 1e-9) << window;
}

TEST(VelocityEstimators, SinusoidsComeOutAsTheTransferFunctionSays) {
  for (const double frequency_hz : {0.8, 10.0, 40.0}) {
    const double omega = 2 * std::numbers::pi * frequency_hz;
    const std::complex<double> shift = std::polar(1.0, -omega * kTickS);  // one tick later
    const auto response = [&](auto estimator) {
      // Whole periods after 1 s of settling: 5 s at 0.8, 10 and 40 Hz.
      const auto seen = speeds(estimator, 6000, [&](double time_s) { return std::sin(omega * time_s); });
      std::complex<double> sum = 0;
      for (int i = 1000; i < 6000; ++i) sum += seen[static_cast<std::size_t>(i)] * std::polar(1.0, -omega * i * kTickS);
      return sum * std::complex<double>(0, 2) / 5000.0;  // of sin(wt) itself this is 1
    };
    const auto near = [&](std::complex<double> found, std::complex<double> wanted) {
      EXPECT_NEAR(std::abs(found - wanted), 0, 1e-6 * omega) << frequency_hz;
    };
    const auto difference = (1.0 - shift) / kTickS;
    near(response(DifferenceVelocity()), difference);
    const auto stage = (1 - pole()) / (1.0 - pole() * shift);
    near(response(LowPassVelocity()), difference * stage * stage);
    const int n = 8;
    near(response(Adaptive(Line::kEndFit, kWide, n)), (1.0 - std::pow(shift, n)) / (n * kTickS));
    // Least squares over n + 1 positions: weights 12 (n/2 - i) / (n (n+1) (n+2) T).
    std::complex<double> best = 0;
    for (int i = 0; i <= n; ++i) best += 12 * (n / 2.0 - i) / (n * (n + 1) * (n + 2) * kTickS) * std::pow(shift, i);
    near(response(Adaptive(Line::kBestFit, kWide, n)), best);
  }
}

TEST(VelocityEstimators, CountsMakeTheNoiseThatTheyMust) {
  // A slow push of 5 mm/s: a count every 11 ms.
  const auto push = [](double time_s) { return counted(5 * time_s); };
  const auto rms = [](const std::vector<double>& seen) {
    double sum = 0;
    for (std::size_t i = 500; i < seen.size(); ++i) sum += (seen[i] - 5) * (seen[i] - 5);
    return std::sqrt(sum / static_cast<double>(seen.size() - 500));
  };
  const auto largest = [](const std::vector<double>& seen) {
    double most = 0;
    for (std::size_t i = 500; i < seen.size(); ++i) most = std::max(most, std::abs(seen[i] - 5));
    return most;
  };
  const auto raw = speeds(DifferenceVelocity(), 4000, push);
  EXPECT_NEAR(largest(raw), 50, 1e-6);                    // 55 mm/s for a tick, 0 otherwise
  EXPECT_NEAR(rms(raw), std::sqrt(5.0 * (55 - 5)), 0.2);  // of a pulse: sqrt(v (V - v)); 318 whole periods
  // Between two counted positions 15 ms apart lies at most one count too much or too little.
  const auto end_fit = speeds(Adaptive(Line::kEndFit, 0.055), 4000, push);
  EXPECT_LE(largest(end_fit), 0.055 / 0.015 + 1e-9);
  const auto best_fit = speeds(Adaptive(Line::kBestFit, 0.055), 4000, push);
  EXPECT_LT(rms(best_fit), rms(end_fit));
  EXPECT_LT(largest(speeds(LowPassVelocity(), 4000, push)), 5);
}

TEST(VelocityEstimators, AWindowNeverReachesOverACorner) {
  // At rest, then 200 mm/s: 0.2 mm in the first tick is more than the bound. A line over one tick of motion and one of
  // rest misses the corner by 0.1 mm.
  const auto start = [](double time_s) { return 200 * std::max(0.0, time_s - 0.05); };
  Adaptive estimator(Line::kEndFit, 0.055);
  for (int i = 0; i <= 50; ++i) estimator.next(start(i * kTickS), kTickS);
  EXPECT_EQ(estimator.window(), 15);
  for (int i = 51; i < 80; ++i) {
    EXPECT_NEAR(estimator.next(start(i * kTickS), kTickS), 200, 1e-9) << i;
    EXPECT_EQ(estimator.window(), std::min(i - 50, 15));
  }
}

TEST(VelocityEstimators, UnevenTicksAreWeighedByTheirLength) {
  for (const Line line : {Line::kEndFit, Line::kBestFit}) {
    Adaptive estimator(line);
    double time_s = 0;
    double speed_mm_s = 0;
    for (int i = 0; i < 100; ++i) {
      const double dt_s = kTickS * (1 + i % 3);
      time_s += dt_s;
      speed_mm_s = estimator.next(-40 * time_s, dt_s);
    }
    EXPECT_NEAR(speed_mm_s, -40, 1e-9);
  }
}

template <typename Estimator>
void expectForgets(Estimator estimator) {
  Estimator used = estimator;
  for (int i = 0; i < 50; ++i) used.next(1000 + 3 * i * i, kTickS);
  used.reset();
  for (int i = 0; i < 50; ++i) ASSERT_EQ(used.next(0.1 * i, kTickS), estimator.next(0.1 * i, kTickS)) << i;
}

TEST(VelocityEstimators, ResetForgetsAllPositions) {
  expectForgets(DifferenceVelocity());
  expectForgets(LowPassVelocity());
  expectForgets(Adaptive(Line::kEndFit));
  expectForgets(Adaptive(Line::kBestFit, 0.08, 7));
}

}  // namespace
}  // namespace tactus::haptics
