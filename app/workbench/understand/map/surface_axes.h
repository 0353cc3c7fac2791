// What stands around a surface: walls with a grid, axes with numbers and names at the edges where they can be read, and
// the landmarks of a depth axis at the upper edge. Moves along while the surface is turned. No widget, no painting.
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
#include "app/workbench/understand/map/surface_projection.h"
#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

struct SurfaceText {
  QString text;
  TurnedBox box;
};

struct SurfaceAxes {
  std::array<QPolygonF, 3> walls;    ///< behind the surface: across x, across y, and the floor or ceiling
  QVector<QLineF> grid;              ///< on the walls
  QVector<QLineF> edges;             ///< of the walls
  QVector<QLineF> axis_lines;        ///< axes and their ticks
  std::vector<SurfaceText> numbers;  ///< at the ticks
  std::vector<SurfaceText> names;    ///< of the axes, with their units
  QVector<QPolygonF> landmark_bars;  ///< where the landmarks are
  QVector<QLineF> landmark_leads;    ///< from a bar to its name
  std::vector<SurfaceText> landmarks;
};

/// The axes of a box that is `seen` so, over the universes of `x`, `y` and of the force `z`. Texts are in `font` (those
/// of landmarks in italics) and stand inside `bounds`, px; none overlaps another. A text without room is left out, an
/// axis that points at the viewer has none.
SurfaceAxes surfaceAxes(const SurfaceProjection& seen, const fuzzy::Variable& x, const fuzzy::Variable& y,
                        const fuzzy::Variable& z, const QFont& font, const QRectF& bounds);

/// The ends of a wall along x, y and z: 0 or 1, the one away from the viewer.
BoxPoint farCorner(const SurfaceProjection& seen);

}  // namespace tactus::workbench
