#include "app/workbench/labs/speed/objective_trace.h"

#include <algorithm>
#include <cmath>

#include "elicitation/clustering/fcm_data.h"
#include "elicitation/clustering/fcm_pass.h"
#include "elicitation/clustering/fcm_starts.h"

namespace tactus::workbench {
namespace {

constexpr int kMostIterations = 100;
constexpr double kStill = 1e-6;  // of the range: nothing to see below it

}  // namespace

ObjectiveTrace objectiveTrace(std::span<const double> samples, std::size_t clusters, double m,
                              const std::function<bool()>& keep_going) {
  ObjectiveTrace out;
  const auto data = elicitation::prepareFcmData(samples, {});
  if (!data) return out;
  const auto entries = elicitation::condense(*data);
  if (entries.size() <= clusters) return out;
  std::vector<double> centres = elicitation::quantileStart(entries, clusters);
  elicitation::FcmPass pass(clusters, m);
  elicitation::FcmSums sums;
  for (int i = 0; i <= kMostIterations && !out.converged; ++i) {
    if (!keep_going()) return {};
    pass.run(*data, centres, sums);
    out.objective.push_back(std::ldexp(sums.objective, data->objectiveExponent()));
    double step = 0;
    for (std::size_t k = 0; k < clusters; ++k) {
      const double move = sums.weight[k] > 0 ? sums.pull[k] / sums.weight[k] : 0;
      centres[k] += move;
      step = std::max(step, std::abs(move));
    }
    out.converged = step < kStill * data->range();
  }
  return out;
}

}  // namespace tactus::workbench
