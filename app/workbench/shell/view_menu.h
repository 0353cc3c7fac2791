// The menu View: stages, panels, look, and the way back to the first layout.
#pragma once

#include <QObject>

class QMenu;
class QSettings;

namespace tactus::workbench {

class MainWindow;
class ModelController;

class ViewMenu : public QObject {
  Q_OBJECT

 public:
  /// Lists the screens and panels that `window` has now.
  ViewMenu(MainWindow& window, const ModelController& models, QSettings& settings);

 private:
  void addStages();
  QMenu* addPanels();
  void addLooks();
  void addTextSizes();

  MainWindow& window_;
  QSettings& settings_;
};

}  // namespace tactus::workbench
