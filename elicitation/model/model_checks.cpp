#include "elicitation/model/model_checks.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/analysis/sample_points.h"
#include "core/fuzzy/compiled_model.h"

namespace tactus::elicitation {
namespace {

constexpr std::size_t kPoints = 36;

}  // namespace

base::Result<void> setChecks(fuzzy::ForceModel& model) {
  model.checks.clear();
  const auto compiled = fuzzy::compile(model);
  if (!compiled) return tl::unexpected(compiled.error());
  for (std::size_t i = 1; i <= kPoints; ++i) {
    fuzzy::Check check;
    for (std::size_t k = 0; k < model.inputs.size(); ++k) {
      const auto& input = model.inputs[k];
      const double x = input.min + analysis::halton(i, k) * (input.max - input.min);
      check.in.push_back(std::clamp(std::round(x * 1000) / 1000, input.min, input.max));
    }
    const auto at = compiled->evaluate(check.in);
    check.force = at.force_n;
    check.fired = at.fired;
    model.checks.push_back(std::move(check));
  }
  return {};
}

}  // namespace tactus::elicitation
