// A button with a force word on its color, and the key that says the same.
#pragma once

#include <QAbstractButton>
#include <optional>

namespace tactus::workbench {

class WordButton : public QAbstractButton {
  Q_OBJECT

 public:
  /// Without a color it stands for no answer.
  WordButton(const QString& word, const QString& key, std::optional<QColor> color, QWidget* parent);

  /// Whether it is the present answer.
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
