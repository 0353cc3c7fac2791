// The ring around what the keyboard has reached, and the room that every control leaves for it.
#pragma once

#include <QRectF>

class QPainter;
class QWidget;

namespace tactus::workbench::nurse {

/// px between the edge of a control and its face: a ring of 3 px, 2 px away from the face.
inline constexpr int kRingRoom = 6;

/// The face of a control of `size` px.
inline QRectF faceOf(const QSizeF& size) {
  return QRectF(QPointF(), size).adjusted(kRingRoom, kRingRoom, -kRingRoom, -kRingRoom);
}

/// Whether `control` has the keyboard and somebody moves it there by keys: after Tab or an arrow in its window, until a
/// press of the mouse, of a finger or of a pen. Whoever never moves by keys sees no ring, which would look like a
/// choice.
bool isRinged(const QWidget& control);

/// Gives the keyboard of `within`, or of a part of it, back to its screen. A next question begins so: the card that was
/// chosen before must not stand out.
void giveKeyboardBack(const QWidget& within);

void drawRing(QPainter& painter, const QRectF& face, double corner_radius);

}  // namespace tactus::workbench::nurse
