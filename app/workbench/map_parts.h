// Adds the force over two inputs to the window: as a map and as a surface, with pictures of them.
#pragma once

#include <QObject>

namespace tactus::workbench {

class MainWindow;
class MapPanel;
class ModelController;
class Panel;
class SceneController;

class MapParts : public QObject {
  Q_OBJECT

 public:
  MapParts(MainWindow& window, const ModelController& models, SceneController& scene);

  MapPanel& view() { return *view_; }
  Panel& map() { return *map_; }
  Panel& surface() { return *surface_; }

 private:
  MapPanel* view_;
  Panel* map_;
  Panel* surface_;
};

}  // namespace tactus::workbench
