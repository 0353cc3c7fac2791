// A small padlock, open or closed. Closed: the vertex beside it may not move.
#pragma once

#include <QAbstractButton>

namespace tactus::workbench {

class LockButton : public QAbstractButton {
  Q_OBJECT

 public:
  explicit LockButton(QWidget* parent = nullptr);

  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace tactus::workbench
