// The one button of a page that leads on: filled with the accent color.
#pragma once

#include <QPushButton>

namespace tactus::workbench {

class PrimaryButton : public QPushButton {
  Q_OBJECT

 public:
  explicit PrimaryButton(const QString& text, QWidget* parent = nullptr);

  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace tactus::workbench
