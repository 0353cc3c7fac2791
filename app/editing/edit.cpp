#include "app/editing/edit.h"

#include <utility>

namespace tactus::editing {

base::Result<Edit> finished(fuzzy::ForceModel model, std::string label, std::string stopped) {
  auto compiled = fuzzy::compile(model);
  if (!compiled) return tl::unexpected(std::move(compiled.error()));
  return Edit{std::move(model), std::move(*compiled), std::move(label), std::move(stopped)};
}

void refreshChecks(fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled) {
  for (auto& check : model.checks) {
    const auto result = compiled.evaluate(check.in);
    check.force = result.force_n;
    check.fired = result.fired;
  }
}

}  // namespace tactus::editing
