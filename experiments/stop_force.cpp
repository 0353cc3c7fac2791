#include "experiments/stop_force.h"

#include <algorithm>
#include <vector>

#include "core/study/ordered_probit.h"

namespace tactus::experiments {

StopForce stopForce(std::span<const StopAnswer> answers) {
  StopForce out;
  std::vector<study::TermAtForce> judged;
  for (const StopAnswer& answer : answers) {
    ++out.asked;
    judged.push_back({answer.force_n, answer.would_stop ? std::size_t{1} : std::size_t{0}});
    auto& bound = answer.would_stop ? out.lowest_stop_n : out.highest_on_n;
    if (answer.would_stop) {
      ++out.stops;
      bound = std::min(bound.value_or(answer.force_n), answer.force_n);
    } else {
      bound = std::max(bound.value_or(answer.force_n), answer.force_n);
    }
  }
  if (out.stops > 0 && out.stops < out.asked) out.stop_force_n = study::termThresholds(judged, 2).threshold_n.front();
  return out;
}

}  // namespace tactus::experiments
