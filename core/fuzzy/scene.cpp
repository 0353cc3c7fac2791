#include "core/fuzzy/scene.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/check.h"
#include "core/base/text.h"
#include "core/fuzzy/model_tables.h"

namespace tactus::fuzzy {

base::Result<Scene> Scene::specialise(const CompiledModel& model, std::span<const std::optional<double>> fixed) {
  TACTUS_CHECK(fixed.size() == model.inputCount());
  Scene scene;
  scene.model_ = model;
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    if (fixed[i] && !std::isfinite(*fixed[i])) {
      return base::fail(base::ErrorCode::kValue, "input " + std::to_string(i), base::formatNumber(*fixed[i]),
                        "a finite number");
    }
    scene.point_.push_back(model.clampInput(i, fixed[i].value_or(model.tables().input_min[i])));
    if (!fixed[i]) scene.free_.push_back(i);
  }
  scene.program_ = std::make_shared<const Program>(makeProgram(model.tables(), fixed));
  return scene;
}

Evaluation Scene::evaluate(std::span<const double> free_inputs) const noexcept {
  TACTUS_CHECK(free_inputs.size() == free_.size());
  std::array<double, kMostInputs> point;
  std::copy(point_.begin(), point_.end(), point.begin());
  for (std::size_t f = 0; f < free_.size(); ++f) point[free_[f]] = free_inputs[f];
  return evaluateProgram(model_.tables(), *program_, {point.data(), point_.size()});
}

void Scene::evaluateBatch(std::span<const std::span<const double>> free_inputs, BatchResult out) const noexcept {
  TACTUS_CHECK(free_inputs.size() == free_.size());
  evaluateBatchOf(model_.tables(), *program_, free_inputs, free_, point_, out);
}

}  // namespace tactus::fuzzy
