// Models of the tests as the C interface reads them.
#pragma once

#include <gtest/gtest.h>
#include <memory>
#include <string>

#include "core/fuzzy/force_model.h"
#include "core/model_io/model_file.h"
#include "tactus/tactus.h"

#include "tests/support/ngt_model.h"

namespace tactus::support {

struct FreeHandle {
  void operator()(tactus_model* model) const { tactus_model_free(model); }
  void operator()(tactus_scene* scene) const { tactus_scene_free(scene); }
  void operator()(tactus_tube* tube) const { tactus_tube_free(tube); }
};
using ModelHandle = std::unique_ptr<tactus_model, FreeHandle>;
using SceneHandle = std::unique_ptr<tactus_scene, FreeHandle>;
using TubeHandle = std::unique_ptr<tactus_tube, FreeHandle>;

inline ModelHandle handleOf(const fuzzy::ForceModel& model) {
  const std::string text = model_io::formatModel(model);
  tactus_model* handle = nullptr;
  char message[300];
  EXPECT_EQ(tactus_model_read(text.data(), text.size(), &handle, message, sizeof message), TACTUS_OK) << message;
  return ModelHandle(handle);
}

/// The first two inputs of the NGT model fixed: lubrication and neck flexion.
inline SceneHandle ngtSceneHandle(const tactus_model* model, double lubrication, double neck_flexion_deg) {
  const size_t fixed[] = {0, 1};
  const double values[] = {lubrication, neck_flexion_deg};
  tactus_scene* scene = nullptr;
  char message[300];
  EXPECT_EQ(tactus_scene_make(model, fixed, values, 2, &scene, message, sizeof message), TACTUS_OK) << message;
  return SceneHandle(scene);
}

inline TubeHandle tubeOf(const tactus_scene* scene) {
  tactus_tube* tube = nullptr;
  char message[300];
  EXPECT_EQ(tactus_tube_make(scene, &tube, message, sizeof message), TACTUS_OK) << message;
  return TubeHandle(tube);
}

}  // namespace tactus::support
