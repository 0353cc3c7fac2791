// The lines of the schematic: a head in profile that looks to the left, throat, esophagus and stomach, and the way of
// the tube through them. Drawn for this program, not to scale.
#pragma once

#include <QPainterPath>
#include <QPointF>
#include <QSizeF>
#include <vector>

namespace tactus::workbench::sagittal {

/// The canvas that all lines are on.
inline constexpr double kWidth = 270;
inline constexpr double kHeight = 400;

/// All for a head that is flexed forward by `flexion`, [0, 1].
QPainterPath outline(double flexion);
QPainterPath airway(double flexion);  ///< mouth and windpipe, which the tube must not enter
QPainterPath stomach(double flexion);

/// Where the tip of the tube is at `depth_mm` from the nostril; below 0 it is in front of the nose.
QPointF placeAt(double depth_mm, double flexion);
/// How wide the passage is there, on the canvas.
double widthAt(double depth_mm);
/// Depth of the end of the way, mm.
double endMm();

}  // namespace tactus::workbench::sagittal
