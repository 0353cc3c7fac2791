// A padlock as a drawing.
#pragma once

#include <QColor>
#include <QPixmap>
#include <QPointF>

class QPainter;

namespace tactus::workbench {

/// Draws a padlock of 9 x 12 px around `center`, closed or open.
void drawLock(QPainter& painter, const QPointF& center, const QColor& color, bool closed);

/// A closed one on nothing; `dots`: of the screen, per px.
QPixmap lockPicture(const QColor& color, qreal dots);

}  // namespace tactus::workbench
