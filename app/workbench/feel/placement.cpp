#include "app/workbench/feel/placement.h"

#include <algorithm>

namespace tactus::workbench {

void PlacementMeter::begin(std::uint64_t number) {
  *this = {};
  number_ = number;
}

void PlacementMeter::add(const haptics::Sample& sample, double depth_mm) {
  if (sample.orders < number_) return;
  strokes_ = sample.stroke;
  if (sample.phase == render::Phase::kReleased) return;
  if (ticks_ == 0) first_ns_ = sample.time_ns;
  last_ns_ = sample.time_ns;
  ++ticks_;
  sum_n_ += sample.force_n;
  peak_n_ = std::max(peak_n_, sample.force_n);
  depth_mm_ = std::max(depth_mm_, depth_mm);
}

std::optional<PlacementSummary> PlacementMeter::summary() const {
  if (ticks_ == 0) return std::nullopt;
  PlacementSummary out;
  out.duration_s = static_cast<double>(last_ns_ - first_ns_) * 1e-9;
  out.strokes = strokes_;
  out.peak_force_n = peak_n_;
  out.mean_force_n = sum_n_ / static_cast<double>(ticks_);
  out.depth_mm = depth_mm_;
  return out;
}

}  // namespace tactus::workbench
