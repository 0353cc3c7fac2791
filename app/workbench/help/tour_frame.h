// The frame around the panel of which the tour speaks. It lets the mouse through.
#pragma once

#include <QWidget>

namespace tactus::workbench {

class TourFrame : public QWidget {
  Q_OBJECT

 public:
  explicit TourFrame(QWidget* parent = nullptr);

 protected:
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace tactus::workbench
