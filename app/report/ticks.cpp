#include "app/report/ticks.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/base/check.h"
#include "core/base/text.h"

namespace tactus::report {

namespace {

// Ends of an axis that miss a multiple of the step by rounding only still get their tick.
constexpr double kSlack = 1e-9;

std::string inFourDigits(double value) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.begin(), text.end(), value, std::chars_format::general, 4).ptr;
  return {text.begin(), end};
}

}  // namespace

std::vector<double> niceTicks(double min, double max, int count) {
  TACTUS_CHECK(std::isfinite(min) && std::isfinite(max) && min < max && count >= 2);
  const double raw_step = (max - min) / count;
  const double power = std::pow(10.0, std::floor(std::log10(raw_step)));
  constexpr std::array<double, 4> kFactors = {1, 2, 5, 10};
  // The factor next to the wanted step, on a logarithmic scale.
  double step = power;
  for (const double factor : kFactors) {
    if (std::abs(std::log(factor * power / raw_step)) < std::abs(std::log(step / raw_step))) step = factor * power;
  }
  std::vector<double> ticks;
  const auto first = static_cast<long long>(std::ceil(min / step - kSlack));
  const auto last = static_cast<long long>(std::floor(max / step + kSlack));
  for (long long k = first; k <= last; ++k) ticks.push_back(static_cast<double>(k) * step);
  if (ticks.size() < 2) return {min, max};
  return ticks;
}

std::vector<std::string> tickTexts(const std::vector<double>& ticks) {
  double smallest_gap = 0;
  for (std::size_t i = 1; i < ticks.size(); ++i) {
    const double gap = std::abs(ticks[i] - ticks[i - 1]);
    if (gap > 0) smallest_gap = smallest_gap > 0 ? std::min(smallest_gap, gap) : gap;
  }
  // Numbers too long to read have an exponent.
  const auto longest = [](double value) { return std::abs(value) >= 1e9; };
  if (std::any_of(ticks.begin(), ticks.end(), longest) || smallest_gap < 1e-8) {
    std::vector<std::string> texts;
    for (const double tick : ticks) texts.push_back(inFourDigits(std::abs(tick) < smallest_gap * 0.01 ? 0 : tick));
    return texts;
  }
  // The fewest decimals that show every tick to a hundredth of the gap.
  int decimals = 0;
  const auto exact = [&](double value) {
    const double scale = std::pow(10.0, decimals);
    return std::abs(std::round(value * scale) / scale - value) <= smallest_gap * 0.01;
  };
  while (decimals < 9 && !std::all_of(ticks.begin(), ticks.end(), exact)) ++decimals;
  std::vector<std::string> texts;
  for (const double tick : ticks) texts.push_back(base::formatFixed(tick == 0 ? 0.0 : tick, decimals));
  return texts;
}

}  // namespace tactus::report
