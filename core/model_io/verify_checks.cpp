#include "core/model_io/verify_checks.h"

#include <cmath>

#include "core/base/text.h"
#include "core/fuzzy/compiled_model.h"

namespace tactus::model_io {
namespace {

// Room for rounding of another implementation, far below anything a hand can feel.
constexpr double kTolerance = 1e-12;

std::string outcome(double force, bool fired) {
  return "force " + base::formatNumber(force) + (fired ? ", fired" : ", not fired");
}

}  // namespace

base::Result<void> verifyChecks(const fuzzy::ForceModel& model) {
  const auto compiled = fuzzy::compile(model);
  if (!compiled) return tl::unexpected(compiled.error());
  const double most = kTolerance * (model.output.max - model.output.min);
  for (std::size_t i = 0; i < model.checks.size(); ++i) {
    const fuzzy::Check& check = model.checks[i];
    const auto now = compiled->evaluate(check.in);
    if (now.fired == check.fired && std::abs(now.force_n - check.force) <= most) continue;
    return base::fail(base::ErrorCode::kMismatch, "/checks/" + std::to_string(i), outcome(now.force_n, now.fired),
                      outcome(check.force, check.fired) + ", as the file says");
  }
  return {};
}

}  // namespace tactus::model_io
