// "Force off": red, in one corner of the window while a device gives forces. It acts on the press.
#pragma once

#include <QAbstractButton>

namespace tactus::workbench {

class ForceOffButton : public QAbstractButton {
  Q_OBJECT

 public:
  explicit ForceOffButton(QWidget* parent = nullptr);

  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString keys() const;
};

}  // namespace tactus::workbench
