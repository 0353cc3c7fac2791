// Forces of the C interface: a model at one point and at many.
#include <span>

#include "core/fuzzy/batch.h"
#include "core/runtime/handles.h"
#include "core/runtime/point_tiles.h"

using namespace tactus;  // NOLINT(google-build-using-namespace): the functions below are outside all namespaces
using namespace tactus::runtime;  // NOLINT(google-build-using-namespace)

double tactus_force(const tactus_model* model, const double* inputs, int* fired) {
  if (model == nullptr || inputs == nullptr) return handOut({}, fired);
  const fuzzy::CompiledModel& compiled = model->loaded->compiled;
  return handOut(compiled.evaluate({inputs, compiled.inputCount()}), fired);
}

double tactus_expert_force(const tactus_model* model, size_t expert, const double* inputs, int* fired) {
  if (expert >= tactus_model_experts(model) || inputs == nullptr) return handOut({}, fired);
  const fuzzy::CompiledModel& compiled = model->loaded->compiled;
  return handOut(compiled.evaluateExpert(expert, {inputs, compiled.inputCount()}), fired);
}

void tactus_force_batch(const tactus_model* model, const double* inputs, size_t points, double* force,
                        unsigned char* fired) {
  if (model == nullptr || inputs == nullptr || force == nullptr) return noForces(points, force, fired);
  const fuzzy::CompiledModel& compiled = model->loaded->compiled;
  inTiles(inputs, points, compiled.inputCount(), force, fired,
          [&](std::span<const std::span<const double>> columns, fuzzy::BatchResult out) {
            fuzzy::evaluateBatch(compiled, columns, out);
          });
}

int tactus_clamped(const tactus_model* model, const double* inputs) {
  return tactus_clamped_inputs(model, inputs) != 0 ? 1 : 0;
}

unsigned tactus_clamped_inputs(const tactus_model* model, const double* inputs) {
  if (model == nullptr || inputs == nullptr) return 0;
  unsigned clamped = 0;
  const auto& variables = model->loaded->inputs;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    if (inputs[i] < variables[i].min || inputs[i] > variables[i].max) clamped |= 1U << i;
  }
  return clamped;
}
