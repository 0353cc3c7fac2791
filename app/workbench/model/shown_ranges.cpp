#include "app/workbench/model/shown_ranges.h"

#include <algorithm>
#include <cmath>

namespace tactus::workbench {
namespace {

constexpr double kSmallestShare = 1.0 / 200;  // of the universe
constexpr double kNearlyAll = 1 - 1e-9;

}  // namespace

figures::Interval ShownRanges::of(const fuzzy::Variable& input) const {
  const figures::Interval all{input.min, input.max};
  const auto part = parts_.find(input.id);
  if (part == parts_.end()) return all;
  // Another model may have another universe.
  const figures::Interval inside{std::max(part->second.low, input.min), std::min(part->second.high, input.max)};
  return inside.high - inside.low >= kSmallestShare * (input.max - input.min) ? inside : all;
}

bool ShownRanges::isPart(const fuzzy::Variable& input) const {
  const figures::Interval range = of(input);
  return range.high - range.low < kNearlyAll * (input.max - input.min);
}

void ShownRanges::show(const fuzzy::Variable& input, figures::Interval range) {
  const double all = input.max - input.min;
  if (!(range.high > range.low)) return;
  const double width = std::clamp(range.high - range.low, kSmallestShare * all, all);
  const double middle = range.low / 2 + range.high / 2;
  const double low = std::clamp(middle - width / 2, input.min, input.max - width);
  const figures::Interval before = of(input);
  if (width >= kNearlyAll * all) {
    parts_.erase(input.id);
  } else {
    parts_[input.id] = {low, low + width};
  }
  const figures::Interval now = of(input);
  if (now.low != before.low || now.high != before.high) emit changed(input.id);
}

void ShownRanges::zoom(const fuzzy::Variable& input, double center, double factor) {
  const figures::Interval range = of(input);
  const double at = std::clamp(center, range.low, range.high);
  show(input, {at - (at - range.low) * factor, at + (range.high - at) * factor});
}

void ShownRanges::pan(const fuzzy::Variable& input, double distance) {
  const figures::Interval range = of(input);
  const double by = std::clamp(distance, input.min - range.low, input.max - range.high);
  show(input, {range.low + by, range.high + by});
}

void ShownRanges::showAll(const fuzzy::Variable& input) { show(input, {input.min, input.max}); }

}  // namespace tactus::workbench
