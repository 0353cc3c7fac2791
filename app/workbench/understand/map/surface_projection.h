// The view of a surface's box on the screen.
#pragma once

#include <QPointF>
#include <QRectF>

#include "app/figures/surface_view.h"

namespace tactus::workbench {

using figures::BoxPoint;
using figures::BoxVector;
using figures::kBox;
using figures::SurfaceAngles;

class SurfaceProjection : public figures::SurfaceView {
 public:
  /// Fits the box into `area` (px) at every azimuth, then scales it by `zoom` and shifts it by `shift` px.
  SurfaceProjection(const SurfaceAngles& angles, const QRectF& area, double zoom = 1, QPointF shift = {});

  /// The position of a box point on the screen, px.
  QPointF operator()(const BoxPoint& point) const;

 private:
  QPointF middle_;
  double scale_ = 1;
};

}  // namespace tactus::workbench
