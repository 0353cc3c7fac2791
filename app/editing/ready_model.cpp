#include "app/editing/ready_model.h"

#include <utility>

#include "app/editing/edit.h"

namespace tactus::editing {

base::Result<SharedModel> ready(fuzzy::ForceModel model) {
  auto compiled = fuzzy::compile(model);
  if (!compiled) return tl::unexpected(std::move(compiled.error()));
  return std::make_shared<const ReadyModel>(ReadyModel{std::move(model), std::move(*compiled)});
}

SharedModel withFreshChecks(SharedModel model) {
  if (model->model.checks.empty()) return model;
  ReadyModel fresh = *model;
  refreshChecks(fresh.model, fresh.compiled);
  return std::make_shared<const ReadyModel>(std::move(fresh));
}

}  // namespace tactus::editing
