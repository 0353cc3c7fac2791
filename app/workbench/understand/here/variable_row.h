// The variables of the model side by side, one card each. The row scrolls if they do not fit.
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
