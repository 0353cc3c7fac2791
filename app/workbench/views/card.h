// A white panel with round corners: the surface everything on the screen stands on.
#pragma once

#include <QColor>
#include <QFrame>

namespace tactus::workbench {

class Card : public QFrame {
  Q_OBJECT

 public:
  explicit Card(QWidget* parent = nullptr);

  void setColors(const QColor& fill, const QColor& edge);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QColor fill_;
  QColor edge_;
};

}  // namespace tactus::workbench
