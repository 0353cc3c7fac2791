#include "app/workbench/controllers/feel_history.h"

#include <cmath>

namespace tactus::workbench {

void FeelHistory::clear() { *this = {}; }

void FeelHistory::add(const haptics::Sample& sample) {
  if (!any_) start_ns_ = sample.time_ns;
  now_s_ = static_cast<double>(sample.time_ns - start_ns_) * 1e-9;
  const TracePoint point{now_s_, sample.model_force_n, sample.source_force_n, sample.force_n};
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

}  // namespace tactus::workbench
