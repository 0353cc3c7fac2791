// The color of a widget's text.
#pragma once

#include <QColor>
#include <QPalette>
#include <QWidget>

namespace tactus::workbench {

inline void setInk(QWidget& widget, const QColor& ink) {
  QPalette colors = widget.palette();
  colors.setColor(QPalette::WindowText, ink);
  widget.setPalette(colors);
}

}  // namespace tactus::workbench
