#include "app/workbench/feel/feel_scene.h"

#include "app/workbench/model/patient.h"
#include "app/workbench/model/scene_controller.h"

namespace tactus::workbench {

base::Result<std::shared_ptr<const haptics::ServoScene>> servoSceneOf(const SceneController& scene, double fade_s) {
  const fuzzy::ForceModel& model = scene.model()->model;
  haptics::Conditions conditions;
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    const std::string& id = model.inputs[i].id;
    if (id != kDepthId && id != kSpeedId) conditions[id] = scene.value(i);
  }
  haptics::SceneSettings settings;
  settings.moved = {kDepthId, kSpeedId};
  settings.fade_s = fade_s;
  return haptics::ServoScene::make(model, conditions, settings);
}

}  // namespace tactus::workbench
