#include "app/workbench/collect/force_trace.h"

#include "experiments/force_protocol.h"

namespace tactus::workbench {

void ForceTrace::add(std::span<const haptics::Sample> samples) {
  for (const haptics::Sample& sample : samples) {
    // Another run of the device begins another trace.
    if (!points_.empty() && sample.time_ns < points_.back().time_ns) points_.clear();
    if (!points_.empty() && sample.time_ns - points_.back().time_ns < kStepNs) continue;
    points_.push_back({sample.time_ns, sample.source_force_n, sample.force_n, sample.position_mm});
  }
  const auto span_ns = static_cast<std::int64_t>(kSeconds * 1e9);
  while (!points_.empty() && points_.back().time_ns - points_.front().time_ns > span_ns) points_.pop_front();
}

void ForceTrace::clear() { points_.clear(); }

bool ForceTrace::isCut() const {
  const Point* const now = newest();
  return now != nullptr && now->commanded_n > 0.05 && now->delivered_n < experiments::kLeastShare * now->commanded_n;
}

}  // namespace tactus::workbench
