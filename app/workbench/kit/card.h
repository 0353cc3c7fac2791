// A white panel with round corners: the surface everything on the screen stands on.
#pragma once

#include <QColor>
#include <QFrame>
#include <optional>

namespace tactus::workbench {

class Card : public QFrame {
  Q_OBJECT

 public:
  explicit Card(QWidget* parent = nullptr);

  /// Colors of the theme follow a change of the look.
  void setColors(const QColor& fill, const QColor& edge);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::optional<QColor> fill_;  ///< nothing: that of cards
  std::optional<QColor> edge_;
};

}  // namespace tactus::workbench
