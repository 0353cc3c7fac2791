// A line of text that becomes shorter or ends in an ellipsis if it does not fit. Its tool tip then has the whole text,
// and what the text means.
#pragma once

#include <QLabel>

namespace tactus::workbench {

class ElidedLabel : public QLabel {
  Q_OBJECT

 public:
  explicit ElidedLabel(QWidget* parent = nullptr);

  /// Shows `brief` if `text` does not fit. Without `brief` the end of `text` is cut.
  void setFullText(const QString& text, const QString& brief = {});
  /// What the text means, below it in the tool tip.
  void setHint(const QString& hint);

  QSize minimumSizeHint() const override;
  QSize sizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void elide();

  QString full_;
  QString brief_;
  QString hint_;
};

}  // namespace tactus::workbench
