// Names beside a picture, each on a plate with a line to its place.
#pragma once

#include <QPointF>
#include <QRectF>
#include <QString>
#include <vector>

class QPainter;

namespace tactus::workbench::anatomy {

/// A name to show in a picture.
struct PlateName {
  QString text;
  QPointF at;            ///< what it names, px
  bool on_left = false;  ///< the edge of the picture at which it stands
  bool lit = false;      ///< bold
  double least_y = 0;    ///< px, the plate stands no higher
};

/// Draws the plates into `area` at their edges, in the order of their places, without overlap, in the font of
/// `painter`.
void drawPlates(QPainter& painter, const QRectF& area, std::vector<PlateName> names);

}  // namespace tactus::workbench::anatomy
