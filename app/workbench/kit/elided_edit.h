// A name that can be edited: while it is not, one that is too long ends in an ellipsis.
#pragma once

#include <QLineEdit>

namespace tactus::workbench {

class ElidedEdit : public QLineEdit {
  Q_OBJECT

 public:
  explicit ElidedEdit(QWidget* parent = nullptr);

 protected:
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace tactus::workbench
