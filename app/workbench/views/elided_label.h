// A line of text that ends in an ellipsis where it does not fit, and then shows the whole text as its tool tip.
#pragma once

#include <QLabel>

namespace tactus::workbench {

class ElidedLabel : public QLabel {
  Q_OBJECT

 public:
  explicit ElidedLabel(QWidget* parent = nullptr);

  void setFullText(const QString& text);

  QSize minimumSizeHint() const override;
  QSize sizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void elide();

  QString full_;
};

}  // namespace tactus::workbench
