// A panel with round corners: the background of all content on the screen.
#pragma once

#include <QColor>
#include <QFrame>
#include <optional>

namespace tactus::workbench {

class Card : public QFrame {
  Q_OBJECT

 public:
  explicit Card(QWidget* parent = nullptr);

  /// A theme color follows a change of the look.
  void setColors(const QColor& fill, const QColor& edge);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::optional<QColor> fill_;  ///< nothing: the theme's card color
  std::optional<QColor> edge_;
};

}  // namespace tactus::workbench
