// Small pictures beside words: strength, lubrication, speed, a tick. Never the word on a color, never color alone.
#pragma once

#include <QRectF>
#include <functional>

class QPainter;

namespace tactus::workbench::nurse {

/// Draws into a rectangle, px.
using Picture = std::function<void(QPainter&, const QRectF&)>;

/// Five bars of rising height, `level` of them filled, 1 to 5.
Picture strengthPicture(int level);
/// A tube with one, two or three drops, `level` 1 to 3; the third lies in a film.
Picture lubricationPicture(int level);
/// The tip of a tube with one, two or three arrows, `level` 1 to 3.
Picture speedPicture(int level);
/// The letter A as large as text of `percent`.
Picture textSizePicture(int percent);
/// A handle with an arrow away from the hand.
Picture pushPicture();
/// A tick in a disk.
Picture tickPicture();
/// A cup of tea.
Picture cupPicture();
void drawTick(QPainter& painter, const QRectF& box, double width);

}  // namespace tactus::workbench::nurse
