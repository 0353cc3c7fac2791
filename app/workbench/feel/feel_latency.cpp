#include "app/workbench/feel/feel_latency.h"

#include <algorithm>

namespace tactus::workbench {

void FeelLatency::take(const haptics::Sample& sample) {
  for (; !pending_.empty() && pending_.front().number <= sample.orders; pending_.pop_front()) {
    EditLatency latency = value_.value_or(EditLatency{});
    latency.last_ticks = sample.tick - pending_.front().ticks_before;
    latency.longest_ticks = std::max(latency.longest_ticks, latency.last_ticks);
    value_ = latency;
  }
}

}  // namespace tactus::workbench
