#include "core/fuzzy/scene.h"

#include <array>
#include <cmath>
#include <memory_resource>

#include "core/base/check.h"
#include "core/base/text.h"
#include "core/fuzzy/kernels.h"
#include "core/fuzzy/model_tables.h"

namespace tactus::fuzzy {

namespace {

/// A program and the memory of its tables.
struct OwnedProgram {
  OwnedProgram(const BatchProgram& from, std::span<const std::optional<double>> fixed)
      : program(specialized(from, fixed, &memory)) {}

  std::pmr::monotonic_buffer_resource memory{8192};  // enough for some experts with some dozens of rules; it grows
  BatchProgram program;
};

}  // namespace

base::Result<Scene> Scene::specialize(const CompiledModel& model, std::span<const std::optional<double>> fixed,
                                      SceneUse use) {
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
  if (use == SceneUse::kPoints) return scene;
  const auto owned =
      std::make_shared<const OwnedProgram>(model.tables().program.batch, std::span(clamped).first(fixed.size()));
  scene.program_ = {owned, &owned->program};
  return scene;
}

Evaluation Scene::evaluate(std::span<const double> free_inputs) const noexcept {
  TACTUS_CHECK(free_inputs.size() == free_.size());
  const ModelTables& tables = model_.tables();
  std::array<double, kMostInputs> point = point_;
  for (std::size_t f = 0; f < free_.size(); ++f) point[free_[f]] = free_inputs[f];
  return evaluatePoint(tables, *tables.program.kernels, std::span(point).first(model_.inputCount()));
}

void Scene::evaluateBatch(std::span<const std::span<const double>> free_inputs, BatchResult out) const noexcept {
  TACTUS_CHECK(free_inputs.size() == free_.size());
  TACTUS_CHECK(program_ != nullptr);
  evaluateBatchOf(model_.tables(), *program_, free_inputs, free_, std::span(point_).first(model_.inputCount()), out);
}

}  // namespace tactus::fuzzy
