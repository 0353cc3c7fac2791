// The screen of the stages that show the open model: its header and the panels of the current stage.
#pragma once

#include <QWidget>

class QSettings;

namespace tactus::workbench {

class ModelHeader;
class PanelArea;
class SceneController;

class BenchView : public QWidget {
  Q_OBJECT

 public:
  BenchView(SceneController& scene, QSettings& settings, QWidget* parent = nullptr);

  PanelArea& panels() { return *panels_; }
  ModelHeader& header() { return *header_; }

 private:
  ModelHeader* header_;
  PanelArea* panels_;
};

}  // namespace tactus::workbench
