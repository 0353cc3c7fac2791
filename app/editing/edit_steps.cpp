#include "app/editing/edit_steps.h"

#include <cmath>

namespace tactus::editing {
namespace {

struct UnitSteps {
  const char* unit;
  double fine;
  double coarse;
};

constexpr UnitSteps kSteps[] = {{"mm", 1, 10}, {"mm/s", 1, 10}, {"deg", 1, 5}, {"N", 0.01, 0.05}};

double roundBelow(double value) {
  constexpr double kRounding = 1 + 1e-9;  // a hundredth of 1 is a step itself
  const double power = std::pow(10, std::floor(std::log10(value * kRounding)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= value * kRounding) return factor * power;
  }
  return power;
}

}  // namespace

double editStep(const fuzzy::Variable& variable, StepSize size) {
  for (const auto& steps : kSteps) {
    if (variable.unit == steps.unit) return size == StepSize::kFine ? steps.fine : steps.coarse;
  }
  constexpr double kFineShare = 0.01;
  constexpr double kCoarseShare = 0.1;
  return roundBelow((variable.max - variable.min) * (size == StepSize::kFine ? kFineShare : kCoarseShare));
}

double stepped(double value, double step, int count) {
  constexpr double kOnGrid = 1e-9;
  const double steps = value / step;
  const double nearest = std::round(steps);
  if (std::abs(steps - nearest) > kOnGrid * std::fmax(1, std::abs(nearest))) return value + count * step;
  // Dividing by a whole number rounds once, so 0.3 is the double nearest to 0.3.
  const double inverse = std::round(1 / step);
  const double place = nearest + count;
  return step < 1 && std::abs(inverse * step - 1) < kOnGrid ? place / inverse : place * step;
}

}  // namespace tactus::editing
