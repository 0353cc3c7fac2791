// Scenes of the C interface.
#include "core/fuzzy/scene.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/files/checksums.h"
#include "core/base/text.h"
#include "core/runtime/handles.h"
#include "core/runtime/message.h"
#include "core/runtime/point_tiles.h"

namespace tactus::runtime {
namespace {

using Fixed = std::vector<std::optional<double>>;

/// One entry per input of the model; a sentence where `fixed` and `values` do not name inputs and values for them.
tl::expected<Fixed, std::string> fixedInputs(const LoadedModel& model, std::span<const std::size_t> fixed,
                                             const double* values) {
  Fixed out(model.inputs.size());
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    const std::string place = "fixed input " + std::to_string(i) + ": ";
    if (fixed[i] >= out.size()) {
      return tl::unexpected(place + "found the index " + std::to_string(fixed[i]) + ", wanted 0 to " +
                            std::to_string(out.size() - 1));
    }
    const std::string name = base::quoted(model.inputs[fixed[i]].id);
    if (out[fixed[i]]) return tl::unexpected(place + "found " + name + " again, wanted each input once");
    if (!std::isfinite(values[i])) {
      return tl::unexpected(place + "found " + base::formatNumber(values[i]) + " for " + name +
                            ", wanted a finite number");
    }
    out[fixed[i]] = values[i];
  }
  return out;
}

/// Names the fixed values that are outside their universes; empty where there are none.
std::string clampedValues(const LoadedModel& model, const Fixed& fixed) {
  std::vector<std::string> said;
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    const double used = fixed[i] ? model.compiled.clampInput(i, *fixed[i]) : 0;
    if (!fixed[i] || used == *fixed[i]) continue;
    said.push_back(base::quoted(model.inputs[i].id) + ": found " + base::formatNumber(*fixed[i]) + ", taken as " +
                   base::formatNumber(used));
  }
  return base::joined(said, "; ");
}

/// Equal for scenes with the same force, in any process.
std::string identityOf(const LoadedModel& model, const Fixed& fixed) {
  std::string text = model.sha256;
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    if (fixed[i])
      text += ' ' + std::to_string(i) + ' ' +
              std::to_string(std::bit_cast<std::uint64_t>(model.compiled.clampInput(i, *fixed[i])));
  }
  return base::sha256(text);
}

/// What the tube needs of a scene, or the sentence why it has no tube.
void addTube(const LoadedModel& model, const Fixed& fixed, tactus_scene& scene) {
  render::TubeSettings settings;
  settings.renderer = model.renderer;
  std::vector<std::string> ids;
  const fuzzy::Variable* depth = nullptr;
  const fuzzy::Variable* speed = nullptr;
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    if (fixed[i]) continue;
    const fuzzy::Variable& input = model.inputs[i];
    const fuzzy::Role role = fuzzy::roleOf(input);
    if (role == fuzzy::Role::kWay) {
      depth = &input;
      settings.depth = ids.size();
      settings.depth_end_mm = input.max;
      settings.events = render::TubeEvents(input, model.events, model.renderer.depth_offset_mm);
    } else if (role == fuzzy::Role::kRate) {
      speed = &input;
      settings.speed = ids.size();
    }
    ids.push_back(base::quoted(input.id));
  }
  const auto rate = fuzzy::rateOf(model.inputs);
  const bool rate_is_free = speed != nullptr || !rate;
  if (depth == nullptr || !rate_is_free || ids.size() != (rate ? 2U : 1U)) {
    const auto way = fuzzy::wayOf(model.inputs);
    std::string wanted = way ? base::quoted(model.inputs[*way].id) : "an input that is the way of the tip";
    if (rate) wanted += " and " + base::quoted(model.inputs[*rate].id);
    scene.no_tube = "inputs of the scene: found " + (ids.empty() ? "none" : base::joined(ids, ", ")) + ", wanted " +
                    wanted + " and no other";
  } else if (const auto units = render::checkTubeUnits(depth, speed, model.output); !units) {
    scene.no_tube = units.error().message();
  } else {
    FeltScene felt{render::TubeScene(scene.scene, settings), identityOf(model, fixed), {}, depth->min, depth->max};
    for (const fuzzy::Term& term : depth->terms) felt.regions.push_back(fuzzy::MembershipFunction::of(term));
    scene.tube = std::make_shared<const FeltScene>(std::move(felt));
  }
}

}  // namespace
}  // namespace tactus::runtime

using namespace tactus;  // NOLINT(google-build-using-namespace): the functions below are outside all namespaces
using namespace tactus::runtime;  // NOLINT(google-build-using-namespace)

tactus_status tactus_scene_make(const tactus_model* model, const size_t* fixed, const double* values,
                                size_t fixed_count, tactus_scene** scene, char* message, size_t message_size) {
  Message said(message, message_size);
  if (scene == nullptr)
    return said.fail(TACTUS_BAD_ARGUMENT, "scene: found a null pointer, wanted a place for the scene");
  *scene = nullptr;
  if (model == nullptr) return said.fail(TACTUS_BAD_ARGUMENT, "model: found a null pointer, wanted a model");
  const LoadedModel& loaded = *model->loaded;
  if (fixed_count > loaded.inputs.size() || (fixed_count > 0 && (fixed == nullptr || values == nullptr))) {
    return said.fail(TACTUS_BAD_ARGUMENT, fixed_count > loaded.inputs.size()
                                              ? "fixed: found more fixed inputs than the model has inputs"
                                              : "fixed: found a null pointer, wanted fixed inputs and their values");
  }
  return guarded(said, [&] {
    const auto inputs = fixedInputs(loaded, {fixed, fixed_count}, values);
    if (!inputs) return said.fail(TACTUS_BAD_ARGUMENT, inputs.error());
    auto specialized = fuzzy::Scene::specialize(loaded.compiled, *inputs);
    if (!specialized) return said.fail(TACTUS_BAD_ARGUMENT, specialized.error().message());
    auto made = std::make_unique<tactus_scene>(tactus_scene{std::move(*specialized), nullptr, {}});
    addTube(loaded, *inputs, *made);
    const std::string clamped = clampedValues(loaded, *inputs);
    said.say(clamped);
    *scene = made.release();
    return TACTUS_OK;
  });
}

void tactus_scene_free(tactus_scene* scene) { delete scene; }

size_t tactus_scene_inputs(const tactus_scene* scene) { return scene != nullptr ? scene->scene.freeInputCount() : 0; }

double tactus_scene_force(const tactus_scene* scene, const double* inputs, int* fired) {
  if (scene == nullptr) return handOut({}, fired);
  const std::size_t count = scene->scene.freeInputCount();
  if (inputs == nullptr && count > 0) return handOut({}, fired);
  return handOut(scene->scene.evaluate({inputs, count}), fired);
}

void tactus_scene_force_batch(const tactus_scene* scene, const double* inputs, size_t points, double* force,
                              unsigned char* fired) {
  const std::size_t count = tactus_scene_inputs(scene);
  if (scene == nullptr || force == nullptr || (inputs == nullptr && count > 0)) return noForces(points, force, fired);
  inTiles(inputs, points, count, force, fired,
          [&](std::span<const std::span<const double>> columns, fuzzy::BatchResult out) {
            scene->scene.evaluateBatch(columns, out);
          });
}
