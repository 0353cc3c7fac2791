// Adds the force curves to the window: their panel, the forces at the place that is read, the ghost (the model before
// an edit) and reference curves from files. The settings keep the user's choices for the next start.
#pragma once

#include <QObject>

class QAction;
class QSettings;

namespace tactus::workbench {

class CurvesPanel;
class EditController;
class GhostController;
class MainWindow;
class ModelController;
class Panel;
class ReferenceController;
class SceneController;

class CurveParts : public QObject {
  Q_OBJECT

 public:
  CurveParts(MainWindow& window, const ModelController& models, SceneController& scene, const EditController& edits,
             GhostController& ghost, ReferenceController& references, QSettings& settings);

  CurvesPanel& view() { return *curves_; }
  Panel& curves() { return *curves_panel_; }
  /// The forces at the place that is read.
  Panel& reading() { return *reading_panel_; }

 private:
  void addActions();
  void addZoom(SceneController& scene);
  void keepChoices(GhostController& ghost);
  void chooseReference();
  void openReferences();
  void storeReferences();

  MainWindow& window_;
  const ModelController& models_;
  ReferenceController& references_;
  QSettings& settings_;
  CurvesPanel* curves_ = nullptr;
  Panel* curves_panel_ = nullptr;
  Panel* reading_panel_ = nullptr;
};

}  // namespace tactus::workbench
