// Finds the part of a term under the mouse. Plain geometry in pixels.
#pragma once

#include <QPointF>
#include <QRectF>
#include <optional>
#include <vector>

#include "app/workbench/tune/terms/term_grip.h"

namespace tactus::workbench {

/// The rectangle of a membership plot, and the values at its sides.
struct PlotFrame {
  QRectF area;      ///< px
  double low = 0;   ///< value at the left side, in the unit of the variable
  double high = 1;  ///< at the right side
  double top = 1;   ///< membership at the upper side; 0 at the lower side

  QPointF pixelOf(double x, double membership) const;
  double valueAt(double x_px) const;
};

// The largest distance to the mouse, px. Sized for fingers on a touch screen and tired eyes, not for the marks.
inline constexpr double kVertexReach = 12;
inline constexpr double kEdgeReach = 7;

/// The nearest vertex within reach; else the nearest edge; else the term whose shape contains `place`. Of vertices at
/// one place it takes the one that can move to the side of the mouse. A part of the term `preferred` wins.
std::optional<Grip> gripAt(const PlotFrame& frame, const std::vector<fuzzy::Term>& terms, QPointF place,
                           std::optional<std::size_t> preferred);

}  // namespace tactus::workbench
