#include "app/workbench/feel/feel_history.h"

#include <algorithm>
#include <cmath>

namespace tactus::workbench {

void FeelHistory::clear() { *this = {}; }

void FeelHistory::add(const haptics::Sample& sample) {
  if (!any_) start_ns_ = sample.time_ns;
  now_s_ = static_cast<double>(sample.time_ns - start_ns_) * 1e-9;
  const TracePoint point{now_s_, sample.model_force_n, sample.source_force_n, sample.force_n, recordedAt(now_s_)};
  const auto step = static_cast<std::int64_t>(std::floor(now_s_ / kTraceStepS));
  if (!any_ || step != step_) {
    trace_.push_back(point);
  } else if (std::abs(point.friction_n) > std::abs(trace_.back().friction_n)) {
    trace_.back() = point;
  }
  any_ = true;
  step_ = step;
  while (trace_.front().time_s < now_s_ - kTraceS) trace_.pop_front();
}

// The nearest sample: the times of both are of whole ticks, but for rounding.
std::optional<double> FeelHistory::recordedAt(double time_s) const {
  const auto& times = recorded_.time_s;
  const auto after = std::lower_bound(times.begin(), times.end(), time_s);
  if (after == times.end() || (after == times.begin() && *after - time_s > kTraceStepS)) return std::nullopt;
  const bool before_is_nearer = after != times.begin() && time_s - *(after - 1) < *after - time_s;
  return recorded_.force_n[static_cast<std::size_t>(after - times.begin()) - (before_is_nearer ? 1 : 0)];
}

}  // namespace tactus::workbench
