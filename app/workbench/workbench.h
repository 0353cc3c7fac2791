// The composition root of tactus-workbench: owns the controllers and the window, and passes them down.
#pragma once

#include "app/workbench/controllers/model_controller.h"
#include "app/workbench/controllers/recent_files.h"
#include "app/workbench/controllers/scene_controller.h"
#include "app/workbench/views/main_window.h"

class QSettings;

namespace tactus::workbench {

struct Workbench {
  explicit Workbench(QSettings& settings) : scene(models), recent(settings), window(models, scene, recent, settings) {}

  ModelController models;
  SceneController scene;
  RecentFiles recent;
  MainWindow window;
};

}  // namespace tactus::workbench
