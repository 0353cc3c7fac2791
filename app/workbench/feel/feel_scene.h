// The servo's scene: the open model in its current setting.
#pragma once

#include <memory>

#include "core/base/error.h"
#include "core/haptics/sources/servo_scene.h"

namespace tactus::workbench {

class SceneController;

/// The model of `scene` with its values of everything but depth and speed, which the hand moves. The difference to the
/// scene before fades out within `fade_s`. `cost_s`: of one force of the model. Refused: what the servo refuses
/// (haptics::ServoScene::make). A model must be open. It is not compiled again.
base::Result<std::shared_ptr<const haptics::ServoScene>> servoSceneOf(const SceneController& scene, double fade_s,
                                                                      double cost_s);

}  // namespace tactus::workbench
