#include "elicitation/speed/draw_interval.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"
#include "core/base/statistics.h"
#include "elicitation/speed/student_t.h"

namespace tactus::elicitation {
namespace {

/// Widened variances of all parts, their sum, and the fewest degrees of freedom.
struct Widened {
  std::vector<double> variances;
  double draws = 0;
  double sum = 0;
  double fewest_degrees = 0;
};

Widened widened(std::span<const double> variances, std::span<const DrawSpread> parts) {
  TACTUS_CHECK(!parts.empty() && variances.size() == parts.size());
  Widened out;
  out.fewest_degrees = parts.front().degrees;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    out.variances.push_back(variances[i] * parts[i].widening);
    out.draws += variances[i];
    out.sum += out.variances.back();
    out.fewest_degrees = std::min(out.fewest_degrees, parts[i].degrees);
  }
  return out;
}

}  // namespace

DrawSpread spreadOf(std::size_t strokes) {
  TACTUS_CHECK(strokes >= 2);
  const auto n = static_cast<double>(strokes);
  return {n / (n - 1), n - 1};
}

DrawSpread mixedSpread(std::span<const double> variances, std::span<const DrawSpread> parts) {
  const Widened all = widened(variances, parts);
  if (!(all.sum > 0)) return {1, all.fewest_degrees};
  double inverse = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) inverse += all.variances[i] / all.sum / parts[i].degrees;
  return {all.sum / all.draws, 1 / inverse};
}

DrawSpread pooledSpread(std::span<const double> variances, std::span<const DrawSpread> persons) {
  const Widened all = widened(variances, persons);
  if (!(all.sum > 0)) return {1, all.fewest_degrees};
  double inverse = 0;
  for (std::size_t i = 0; i < persons.size(); ++i) {
    const double share = all.variances[i] / all.sum;
    inverse += share * share / persons[i].degrees;
  }
  return {all.sum / all.draws, 1 / inverse};
}

Interval drawInterval(double value, const std::vector<double>& draws, const DrawSpread& spread, double lowest,
                      double coverage) {
  const double sd = base::standardDeviation(draws);
  if (!(sd > 0)) return {value, value};
  const double half = studentQuantile((1 + coverage) / 2, spread.degrees) * std::sqrt(spread.widening) * sd;
  return {std::max(value - half, std::min(lowest, value)), value + half};
}

}  // namespace tactus::elicitation
