// A button with a force word on its color, and the key for the same word.
#pragma once

#include <QAbstractButton>
#include <optional>

namespace tactus::workbench {

class WordButton : public QAbstractButton {
  Q_OBJECT

 public:
  /// Without a color the button means "no answer".
  WordButton(const QString& word, const QString& key, std::optional<QColor> color, QWidget* parent);

  /// Marks the button as the current answer.
  void setMarked(bool marked);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {24, sizeHint().height()}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString key_;
  std::optional<QColor> color_;
  bool marked_ = false;
};

}  // namespace tactus::workbench
