// The settings and families of the paper's figures in a menu. The button has the name of the figure whose family of
// curves is shown.
#pragma once

#include <QPushButton>

namespace tactus::workbench {

class SceneController;

/// Hidden for a model that has other inputs than the figures.
class FigureButton : public QPushButton {
  Q_OBJECT

 public:
  explicit FigureButton(SceneController& scene, QWidget* parent = nullptr);

 private:
  void adoptModel();
  void showFamily();

  SceneController& scene_;
};

}  // namespace tactus::workbench
