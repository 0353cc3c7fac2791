#include "core/analysis/pull/elsewhere.h"

#include <algorithm>
#include <cmath>

#include "core/analysis/force_difference.h"
#include "core/fuzzy/batch.h"

namespace tactus::analysis {
namespace {

constexpr std::size_t kCurvePoints = 601;

}  // namespace

void evaluateColumns(const fuzzy::CompiledModel& compiled, const std::vector<std::vector<double>>& columns,
                     std::span<double> force_n, std::span<std::uint8_t> fired) {
  std::vector<std::span<const double>> inputs(columns.begin(), columns.end());
  fuzzy::evaluateBatch(compiled, inputs, {force_n, fired});
}

ElsewhereProbe::ElsewhereProbe(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                               const std::vector<double>& point, std::size_t curve_input, std::size_t box_points,
                               const NoticeableDifference& noticeable)
    : columns_(model.inputs.size()), curve_points_(kCurvePoints) {
  auto points = linePoints(model, point, curve_input, kCurvePoints);
  const auto box = boxPoints(model, box_points);
  points.insert(points.end(), box.begin(), box.end());
  for (const auto& one : points) {
    for (std::size_t i = 0; i < one.size(); ++i) columns_[i].push_back(one[i]);
  }
  before_ = forces(compiled);
  for (const double force_n : before_.force_n) noticeable_n_.push_back(noticeable(std::abs(force_n)));
}

ElsewhereProbe::Forces ElsewhereProbe::forces(const fuzzy::CompiledModel& model) const {
  Forces out{std::vector<double>(columns_[0].size()), std::vector<std::uint8_t>(columns_[0].size())};
  evaluateColumns(model, columns_, out.force_n, out.fired);
  return out;
}

Elsewhere ElsewhereProbe::of(const fuzzy::CompiledModel& after_model) const {
  const Forces after = forces(after_model);
  Elsewhere out;
  const auto over = [&](std::size_t from, std::size_t to) {
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t k = from; k < to; ++k) {
      if (before_.fired[k] == 0) continue;
      if (after.fired[k] == 0) {
        out.opens_hole = true;
        continue;
      }
      const double change_n = after.force_n[k] - before_.force_n[k];
      out.largest_n = std::max(out.largest_n, std::abs(change_n));
      sum += change_n / noticeable_n_[k] * (change_n / noticeable_n_[k]);
      ++count;
    }
    return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0;
  };
  out.k_curve = over(0, curve_points_);
  out.k_box = over(curve_points_, before_.force_n.size());
  const bool has_box = before_.force_n.size() > curve_points_;
  out.k = has_box ? std::sqrt((out.k_curve * out.k_curve + out.k_box * out.k_box) / 2) : out.k_curve;
  return out;
}

}  // namespace tactus::analysis
