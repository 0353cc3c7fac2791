// The lines of the schematic: a head in profile that looks to the left, throat, esophagus and stomach, and the path of
// the tube. Drawn for this program, not to scale.
#pragma once

#include <QPainterPath>
#include <QPointF>
#include <QSizeF>
#include <vector>

namespace tactus::workbench::sagittal {

/// The size of the canvas, in drawing units.
inline constexpr double kWidth = 270;
inline constexpr double kHeight = 400;

/// All functions take the forward flexion of the head, `flexion` in [0, 1].
QPainterPath outline(double flexion);
QPainterPath airway(double flexion);  ///< mouth and windpipe, which the tube must not enter
QPainterPath stomach(double flexion);

/// The position of the tip at `depth_mm` from the nostril; below 0 it is in front of the nose.
QPointF placeAt(double depth_mm, double flexion);
/// The width of the passage there, in drawing units.
double widthAt(double depth_mm);
/// The depth at the end of the path, mm.
double endMm();

}  // namespace tactus::workbench::sagittal
