#include "core/fuzzy/scene.h"

#include <array>
#include <cmath>

#include "core/base/check.h"
#include "core/base/text.h"
#include "core/fuzzy/kernels.h"
#include "core/fuzzy/model_tables.h"

namespace tactus::fuzzy {

base::Result<Scene> Scene::specialise(const CompiledModel& model, std::span<const std::optional<double>> fixed) {
  TACTUS_CHECK(fixed.size() == model.inputCount());
  Scene scene;
  scene.model_ = model;
  std::array<std::optional<double>, kMostInputs> clamped;
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    if (fixed[i] && !std::isfinite(*fixed[i])) {
      return base::fail(base::ErrorCode::kValue, "input " + std::to_string(i), base::formatNumber(*fixed[i]),
                        "a finite number");
    }
    scene.point_[i] = model.clampInput(i, fixed[i].value_or(model.tables().input_min[i]));
    if (fixed[i]) {
      clamped[i] = scene.point_[i];
    } else {
      scene.free_.push_back(i);
    }
  }
  scene.program_ = std::make_shared<const BatchProgram>(
      specialised(model.tables().program.batch, std::span(clamped).first(fixed.size())));
  return scene;
}

Evaluation Scene::evaluate(std::span<const double> free_inputs) const noexcept {
  TACTUS_CHECK(free_inputs.size() == free_.size());
  const ModelTables& tables = model_.tables();
  std::array<double, kMostInputs> point = point_;
  double nothing = 0;
  for (std::size_t f = 0; f < free_.size(); ++f) {
    nothing += free_inputs[f] - free_inputs[f];  // NaN where it is NaN or infinite
    point[free_[f]] = model_.clampInput(free_[f], free_inputs[f]);
  }
  if (nothing != 0) return kNotANumber;
  return evaluateClamped(tables, *tables.program.kernels, std::span(point).first(model_.inputCount()));
}

void Scene::evaluateBatch(std::span<const std::span<const double>> free_inputs, BatchResult out) const noexcept {
  TACTUS_CHECK(free_inputs.size() == free_.size());
  evaluateBatchOf(model_.tables(), *program_, free_inputs, free_, std::span(point_).first(model_.inputCount()), out);
}

}  // namespace tactus::fuzzy
