// Evaluation of a gradient: the mean over the experts, and the slots.
#include "core/analysis/gradient/gradient.h"

#include <algorithm>

#include "core/analysis/gradient/gradient_paths.h"
#include "core/base/check.h"

namespace tactus::analysis {

void GradientModel::evaluate(std::span<const double> inputs, Gradient& out) const noexcept {
  const GradientTables& tables = *tables_;
  TACTUS_CHECK(inputs.size() == tables.input_min.size() && out.slot_count_ == tables.slot_count);
  std::array<double, fuzzy::kMostInputs> values{};
  bool finite = true;
  bool ordinary = true;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    finite = finite & (inputs[i] - inputs[i] == 0);  // not so for NaN and infinity
    values[i] = std::min(std::max(inputs[i], tables.input_min[i]), tables.input_max[i]);
    ordinary = ordinary & isOrdinary(values[i]);
  }
  if (!finite) return GradientSink::fillWithNan(out);

  const std::span<const double> clamped(values.data(), inputs.size());
  GradientSink sink(out);
  FastPoint fast;
  GeneralPoint general;
  double weights = 0;
  double mean_offset = 0;
  bool all_fire = true;
  for (const GradientExpert& expert : tables.experts) {
    if (expert.weight == 0) continue;
    double offset = 0;
    Firing firing = Firing::kOpen;
    if (expert.fast && ordinary) firing = addFast(tables, expert, clamped, fast, sink, offset);
    if (firing == Firing::kOpen) firing = addGenerally(tables, expert, clamped, general, sink, offset);
    all_fire = all_fire && firing == Firing::kFires;
    if (firing == Firing::kAbstains) continue;
    weights += expert.weight;
    mean_offset += (offset - mean_offset) * (expert.weight / weights);
  }
  out.fired = weights > 0;
  out.force_n = out.fired ? tables.output_min + mean_offset : tables.default_force_n;
  sink.finish(inputs, clamped);
  if (out.fired && !all_fire) sink.divide(weights);
}

Gradient GradientModel::evaluate(std::span<const double> inputs) const {
  Gradient out = makeGradient();
  evaluate(inputs, out);
  return out;
}

}  // namespace tactus::analysis
