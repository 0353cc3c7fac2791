// The ring around what has the keyboard, and the room that every control leaves for it.
#pragma once

#include <QRectF>

class QPainter;

namespace tactus::workbench::nurse {

/// px between the edge of a control and its face: a ring of 3 px, 2 px away from the face.
inline constexpr int kRingRoom = 6;

/// The face of a control of `size` px.
inline QRectF faceOf(const QSizeF& size) {
  return QRectF(QPointF(), size).adjusted(kRingRoom, kRingRoom, -kRingRoom, -kRingRoom);
}

void drawRing(QPainter& painter, const QRectF& face, double corner_radius);

}  // namespace tactus::workbench::nurse
