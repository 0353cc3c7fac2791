// One stage in the rail: its picture, its name, and what is done there.
#pragma once

#include <QAbstractButton>

#include "app/workbench/views/stage.h"

namespace tactus::workbench {

class StageButton : public QAbstractButton {
  Q_OBJECT

 public:
  explicit StageButton(Stage stage, QWidget* parent = nullptr);

  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QRect hintRect() const;

  Stage stage_;
};

}  // namespace tactus::workbench
