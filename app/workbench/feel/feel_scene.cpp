#include "app/workbench/feel/feel_scene.h"

#include "app/workbench/model/patient.h"
#include "app/workbench/model/scene_controller.h"

namespace tactus::workbench {

base::Result<std::shared_ptr<const haptics::ServoScene>> servoSceneOf(const SceneController& scene, double fade_s,
                                                                      double cost_s) {
  const OpenModel& open = *scene.model();
  const fuzzy::ForceModel& model = open.model;
  haptics::Conditions conditions;
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    const std::string& id = model.inputs[i].id;
    if (id != kDepthId && id != kSpeedId) conditions[id] = scene.value(i);
  }
  haptics::SceneSettings settings;
  settings.moved = {kDepthId, kSpeedId};
  settings.fade_s = fade_s;
  settings.known_cost_s = cost_s;
  return haptics::ServoScene::make(model, open.compiled, conditions, settings);
}

}  // namespace tactus::workbench
