#include "tests/support/loop_measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace tactus::support {

namespace {

constexpr double kTickS = 0.001;

}  // namespace

double lowestEnergyMj(const std::vector<LoopTick>& ticks) {
  double energy = 0;
  double lowest = 0;
  for (std::size_t i = 1; i < ticks.size(); ++i) {
    energy += ticks[i - 1].force_n * (ticks[i].position_mm - ticks[i - 1].position_mm);
    lowest = std::min(lowest, energy);
  }
  return lowest;
}

double largestStepN(const std::vector<LoopTick>& ticks) {
  double largest = 0;
  for (std::size_t i = 1; i < ticks.size(); ++i)
    largest = std::max(largest, std::abs(ticks[i].force_n - ticks[i - 1].force_n));
  return largest;
}

double rippleN(const std::vector<LoopTick>& ticks) {
  const double w = std::tan(std::numbers::pi * 30 * kTickS);
  const double norm = 1 / (1 + std::numbers::sqrt2 * w + w * w);
  double x1 = 0, x2 = 0, y1 = 0, y2 = 0, sum = 0;
  for (const LoopTick& tick : ticks) {
    const double y =
        norm * (tick.force_n - 2 * x1 + x2 - 2 * (w * w - 1) * y1 - (1 - std::numbers::sqrt2 * w + w * w) * y2);
    x2 = std::exchange(x1, tick.force_n);
    y2 = std::exchange(y1, y);
    sum += y * y;
  }
  return std::sqrt(sum / static_cast<double>(ticks.size()));
}

double lastSpeedMmS(const std::vector<LoopTick>& ticks) {
  const std::size_t window = std::min<std::size_t>(500, ticks.size() - 1);
  double sum = 0;
  for (std::size_t i = ticks.size() - window; i < ticks.size(); ++i) {
    const double speed = (ticks[i].position_mm - ticks[i - 1].position_mm) / kTickS;
    sum += speed * speed;
  }
  return std::sqrt(sum / static_cast<double>(window));
}

}  // namespace tactus::support
