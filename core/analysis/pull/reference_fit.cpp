#include "core/analysis/pull/reference_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/analysis/pull/elsewhere.h"

namespace tactus::analysis {
namespace {

constexpr int kLooks = 61;
constexpr int kSections = 75;       // 0.618^75 of two looks is below the rounding of a delta
constexpr double kNothing = 1e-12;  // N: rounding of the forces

/// How far `force_n` is outside of [low_n, high_n].
double outside(double force_n, double low_n, double high_n) {
  return force_n < low_n ? low_n - force_n : force_n > high_n ? force_n - high_n : 0;
}

}  // namespace

ReferenceFit::ReferenceFit(const fuzzy::CompiledModel& compiled, const ReferenceCurve& reference,
                           const NoticeableDifference& noticeable) {
  const std::size_t count = reference.low_n.size();
  std::vector<double> force_n(count);
  std::vector<std::uint8_t> fired(count);
  evaluateColumns(compiled, reference.columns, force_n, fired);
  reference_.columns.resize(reference.columns.size());
  for (std::size_t k = 0; k < count; ++k) {
    if (fired[k] == 0) {
      ++left_out_;
      continue;
    }
    for (std::size_t i = 0; i < reference.columns.size(); ++i) {
      reference_.columns[i].push_back(reference.columns[i][k]);
    }
    reference_.low_n.push_back(reference.low_n[k]);
    reference_.high_n.push_back(reference.high_n[k]);
    const double nearest_n = std::clamp(force_n[k], reference.low_n[k], reference.high_n[k]);
    noticeable_n_.push_back(noticeable(std::abs(nearest_n)));
  }
}

std::optional<ReferenceFit::Residual> ReferenceFit::of(const fuzzy::CompiledModel& model) const {
  std::vector<double> force_n(points());
  std::vector<std::uint8_t> fired(points());
  evaluateColumns(model, reference_.columns, force_n, fired);
  Residual sums;
  for (std::size_t k = 0; k < points(); ++k) {
    if (fired[k] == 0) return std::nullopt;
    const double off_n = outside(force_n[k], reference_.low_n[k], reference_.high_n[k]);
    sums.rms_n += off_n * off_n;
    sums.rms_noticeable += off_n / noticeable_n_[k] * (off_n / noticeable_n_[k]);
  }
  const auto count = static_cast<double>(points());
  return Residual{std::sqrt(sums.rms_n / count), std::sqrt(sums.rms_noticeable / count)};
}

std::optional<ReferenceFit::Residual> ReferenceFit::after(const fuzzy::ForceModel& model, const PullEdit& edit) const {
  const auto compiled = fuzzy::compile(applied(model, edit));
  return compiled ? of(*compiled) : std::nullopt;
}

std::optional<double> ReferenceFit::best(const fuzzy::ForceModel& model, PullEdit edit, const DeltaRange& range) const {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const auto left = [&](double delta) {
    edit.delta = delta;
    const auto residual = after(model, edit);
    return residual ? residual->rms_n : kNever;
  };
  const double now = left(0);
  if (left(range.low) == now && left(range.high) == now) return std::nullopt;
  std::array<double, kLooks> deltas;
  std::array<double, kLooks> residuals;
  const double step = (range.high - range.low) / (kLooks - 1);
  std::size_t least = 0;
  for (std::size_t k = 0; k < kLooks; ++k) {
    deltas[k] = k + 1 == kLooks ? range.high : range.low + step * static_cast<double>(k);
    residuals[k] = left(deltas[k]);
    const bool both_nothing = residuals[k] <= kNothing && residuals[least] <= kNothing;
    if (both_nothing ? std::abs(deltas[k]) < std::abs(deltas[least]) : residuals[k] < residuals[least]) least = k;
  }
  if (residuals[least] == kNever) return std::nullopt;
  if (residuals[least] <= kNothing) {  // a band: from here toward 0 until something is left
    double with = deltas[least];
    double without = std::abs(with) <= step ? 0 : with - std::copysign(step, with);
    for (int i = 0; i < kSections && with != without; ++i) {
      const double middle = (with + without) / 2;
      (left(middle) <= kNothing ? with : without) = middle;
    }
    return with;
  }
  constexpr double kGolden = 0.6180339887498949;
  double low = deltas[least == 0 ? 0 : least - 1];
  double high = deltas[least + 1 == kLooks ? least : least + 1];
  double first = high - kGolden * (high - low);
  double second = low + kGolden * (high - low);
  double at_first = left(first);
  double at_second = left(second);
  for (int i = 0; i < kSections && low < first && first < second && second < high; ++i) {
    if (at_first <= at_second) {
      high = second;
      second = std::exchange(first, second - kGolden * (second - low));
      at_second = std::exchange(at_first, left(first));
    } else {
      low = first;
      first = std::exchange(second, first + kGolden * (high - first));
      at_first = std::exchange(at_second, left(second));
    }
  }
  const double found = at_first <= at_second ? first : second;
  return std::min(at_first, at_second) <= residuals[least] ? found : deltas[least];
}

}  // namespace tactus::analysis
