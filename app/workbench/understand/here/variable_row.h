// The variables of the model side by side, one card each; it scrolls where there are too many.
#pragma once

#include <QScrollArea>

namespace tactus::workbench {

class SceneController;

class VariableRow : public QScrollArea {
  Q_OBJECT

 public:
  explicit VariableRow(SceneController& scene, QWidget* parent = nullptr);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 private:
  void build();

  SceneController& scene_;
};

}  // namespace tactus::workbench
