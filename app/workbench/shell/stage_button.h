// One stage in the rail: its picture, its name and its task.
#pragma once

#include <QAbstractButton>

#include "app/workbench/shell/stage.h"

class QPainter;

namespace tactus::workbench {

class StageButton : public QAbstractButton {
  Q_OBJECT

 public:
  explicit StageButton(Stage stage, QWidget* parent = nullptr);

  Stage stage() const { return stage_; }

  /// True: the name stands below the picture, and the task is the tool tip.
  void setCompact(bool compact);

  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QRect hintRect() const;
  void paintRoomy(QPainter& painter, const QColor& ink, const QColor& hint);
  void paintCompact(QPainter& painter, const QColor& ink);

  Stage stage_;
  bool compact_ = false;
};

}  // namespace tactus::workbench
