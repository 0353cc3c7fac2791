#include "elicitation/model_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/fuzzy/compiled_model.h"

namespace tactus::elicitation {
namespace {

constexpr int kPoints = 36;
constexpr std::array<int, fuzzy::kMostInputs> kPrimes{2, 3, 5, 7, 11, 13, 17, 19};

/// The digits of `index` in `prime`, mirrored at the point: the Halton sequence in one dimension.
double radicalInverse(int index, int prime) {
  double out = 0;
  for (double digit = 1.0 / prime; index > 0; index /= prime, digit /= prime) out += digit * (index % prime);
  return out;
}

}  // namespace

base::Result<void> setChecks(fuzzy::ForceModel& model) {
  model.checks.clear();
  const auto compiled = fuzzy::compile(model);
  if (!compiled) return tl::unexpected(compiled.error());
  for (int i = 1; i <= kPoints; ++i) {
    fuzzy::Check check;
    for (std::size_t k = 0; k < model.inputs.size(); ++k) {
      const auto& input = model.inputs[k];
      const double x = input.min + radicalInverse(i, kPrimes[k]) * (input.max - input.min);
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
