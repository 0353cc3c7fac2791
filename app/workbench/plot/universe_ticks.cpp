#include "app/workbench/plot/universe_ticks.h"

#include <cmath>

namespace tactus::workbench {
namespace {

// The step of QCPAxisTicker with its readable steps: 1, 2, 2.5, 5 times a power of ten.
double roundStep(double rough) {
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  double best = power;
  for (const double factor : {1.0, 2.0, 2.5, 5.0, 10.0}) {
    if (std::abs(factor * power - rough) < std::abs(best - rough)) best = factor * power;
  }
  return best;
}

}  // namespace

std::vector<double> universeTicks(double min, double max, int count) {
  std::vector<double> ticks = {min};
  if (count > 1) {
    const double step = roundStep((max - min) / count);
    for (auto i = static_cast<long long>(std::ceil(min / step)); static_cast<double>(i) * step <= max; ++i) {
      const double tick = static_cast<double>(i) * step;
      if (tick - min > 0.6 * step && max - tick > 0.6 * step) ticks.push_back(tick);
    }
  }
  ticks.push_back(max);
  return ticks;
}

}  // namespace tactus::workbench
