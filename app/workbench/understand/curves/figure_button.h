// The menu of the settings and families of the paper's figures. The button shows the figure whose family of curves is
// visible.
#pragma once

#include <QPushButton>

namespace tactus::workbench {

class SceneController;

/// Hidden if the model does not have the inputs of the figures.
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
