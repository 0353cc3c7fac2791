// The surroundings of a surface: walls with a grid, axes with numbers and names at the edges where they are readable,
// and the landmarks of a depth axis at the upper edge. They turn with the surface. No widget, no painting.
#pragma once

#include <QFont>
#include <QLineF>
#include <QPolygonF>
#include <QRectF>
#include <QString>
#include <QVector>
#include <array>
#include <cstddef>
#include <vector>

#include "app/workbench/plot/label_board.h"
#include "app/workbench/understand/map/surface_mesh.h"
#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

/// Where `value` lies in the universe: 0 at its beginning, 1 at its end.
double shareOf(const fuzzy::Variable& variable, double value);

struct SurfaceText {
  QString text;
  TurnedBox box;
};

struct SurfaceAxes {
  std::array<QPolygonF, 3> walls;    ///< behind the surface: across x, across y, and the floor or ceiling
  QVector<QLineF> grid;              ///< on the walls
  QVector<QLineF> edges;             ///< of the walls
  QVector<QLineF> axis_lines;        ///< axes and their ticks
  std::vector<SurfaceText> numbers;  ///< numbers at the ticks
  std::vector<SurfaceText> names;    ///< names of the axes, with their units
  QVector<QPolygonF> landmark_bars;  ///< extents of the landmarks
  QVector<QLineF> landmark_leads;    ///< from a bar to its name
  std::vector<SurfaceText> landmarks;
};

/// The axes of a box seen through `seen`, over the universes of `x`, `y` and of the force `z`. Texts are in `font`
/// (landmarks in italics) and inside `bounds`, px; none overlaps another. A text that does not fit is left out. An axis
/// that points at the viewer has no texts.
SurfaceAxes surfaceAxes(const SurfaceProjection& seen, const fuzzy::Variable& x, const fuzzy::Variable& y,
                        const fuzzy::Variable& z, const QFont& font, const QRectF& bounds);

/// The corner of the box away from the viewer: 0 or 1 along x, y and z.
BoxPoint farCorner(const SurfaceProjection& seen);

}  // namespace tactus::workbench
