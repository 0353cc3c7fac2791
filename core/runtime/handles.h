// What the opaque types of the C interface hold.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/scene.h"
#include "core/render/insertion.h"
#include "tactus/tactus.h"

namespace tactus::runtime {

/// A model file that was read: its evaluator, and what it declares. Shared by the model and its scenes.
struct LoadedModel {
  fuzzy::CompiledModel compiled;
  std::string name;
  std::vector<fuzzy::Variable> inputs;  ///< without their terms
  fuzzy::Variable output;               ///< without its terms
  std::vector<std::string> experts;     ///< ids
  fuzzy::RendererParameters renderer;
};

}  // namespace tactus::runtime

struct tactus_model {
  std::shared_ptr<const tactus::runtime::LoadedModel> loaded;
};

struct tactus_scene {
  tactus::fuzzy::Scene scene;
  std::shared_ptr<const tactus::render::TubeScene> tube;  ///< null: the scene cannot be felt, for the reason `no_tube`
  std::string no_tube;
};

struct tactus_tube {
  tactus::render::Insertion insertion;
  std::shared_ptr<const tactus::render::TubeScene> scene;
  double fade_s = 0;
};
