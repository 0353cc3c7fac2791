#include "elicitation/model/model_checks.h"

#include "core/analysis/check_points.h"
#include "core/fuzzy/validate.h"

namespace tactus::elicitation {
namespace {

// A model in the workbench evaluates them again at every edit.
constexpr std::size_t kMost = 120;

}  // namespace

base::Result<void> setChecks(fuzzy::ForceModel& model) {
  model.checks.clear();
  if (auto ok = fuzzy::validate(model); !ok) return ok;
  model.checks = analysis::ownChecks(model, kMost);
  return {};
}

}  // namespace tactus::elicitation
