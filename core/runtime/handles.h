// What the opaque types of the C interface hold.
#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/membership.h"
#include "core/fuzzy/scene.h"
#include "core/render/insertion.h"
#include "tactus/tactus.h"

namespace tactus::runtime {

/// A model file that was read: its evaluator, and what it declares. Shared by the model and its scenes.
struct LoadedModel {
  fuzzy::CompiledModel compiled;
  std::string name;
  std::string sha256;  ///< of the text that was read
  std::vector<fuzzy::Variable> inputs;
  fuzzy::Variable output;              ///< without its terms
  std::vector<fuzzy::Expert> experts;  ///< without their rules
  fuzzy::RendererParameters renderer;
  std::vector<fuzzy::TubeEvent> events;
};

/// What a tube keeps of its scene. Immutable.
struct FeltScene {
  render::TubeScene scene;
  std::string identity;                            ///< SHA-256 of the model's text and of the fixed inputs
  std::vector<fuzzy::MembershipFunction> regions;  ///< the terms of `depth`
  double depth_min_mm = 0;                         ///< universe of `depth`
  double depth_max_mm = 0;
};

}  // namespace tactus::runtime

struct tactus_model {
  std::shared_ptr<const tactus::runtime::LoadedModel> loaded;
};

struct tactus_scene {
  tactus::fuzzy::Scene scene;
  std::shared_ptr<const tactus::runtime::FeltScene> tube;  ///< null: the scene cannot be felt, for the reason `no_tube`
  std::string no_tube;
};

struct tactus_tube {
  static constexpr double kMostForceN = 2;

  tactus::render::Insertion insertion;
  std::shared_ptr<const tactus::runtime::FeltScene> scene;
  double fade_s = 0;
  double stiffness_max_n_mm = std::numeric_limits<double>::infinity();  ///< of the caller
  double force_cap_n = kMostForceN;
};
