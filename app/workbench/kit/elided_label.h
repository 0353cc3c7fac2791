// A line of text that gets shorter or ends in an ellipsis where it does not fit, and then has the whole text as its
// tool tip.
#pragma once

#include <QLabel>

namespace tactus::workbench {

class ElidedLabel : public QLabel {
  Q_OBJECT

 public:
  explicit ElidedLabel(QWidget* parent = nullptr);

  /// `brief` stands in the place of `text` where that does not fit; without it the end of `text` is left out.
  void setFullText(const QString& text, const QString& brief = {});

  QSize minimumSizeHint() const override;
  QSize sizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void elide();

  QString full_;
  QString brief_;
};

}  // namespace tactus::workbench
