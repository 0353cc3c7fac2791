// The picture of a surface: its contents, its angle, and its painting, at once or in slices. No widget.
#pragma once

#include <QImage>
#include <QPointF>
#include <QRectF>
#include <memory>

#include "app/workbench/understand/map/surface_axes.h"
#include "app/workbench/understand/map/surface_mesh.h"
#include "app/workbench/understand/map/surface_painting.h"
#include "app/workbench/understand/map/surface_projection.h"
#include "core/fuzzy/force_model.h"

class QPainter;

namespace tactus::workbench {

struct SurfaceLook {
  SurfaceAngles angles;
  double zoom = 1;
  QPointF shift;  ///< px

  friend bool operator==(const SurfaceLook&, const SurfaceLook&) = default;
};

struct SurfaceFrame {
  fuzzy::Variable x;
  fuzzy::Variable y;
  fuzzy::Variable output;
  SurfaceLook look;
  QSizeF size;  ///< px of the whole drawing

  /// The areas of the box, the color scale beside it, and the texts.
  QRectF boxArea() const;
  QRectF scaleArea() const;
  QRectF textArea() const;
  SurfaceProjection projection() const;
  SurfaceAxes axes() const;
};

/// Paints the whole picture. `mesh` may be null if nothing is computed yet. Returns the painting time of the mesh, ns.
double paintSurface(QPainter& painter, const SurfaceFrame& frame, std::shared_ptr<const SurfaceMesh> mesh,
                    SurfacePainting::Quality quality);

/// A picture that is painted in slices into its own image.
class SurfaceImage {
 public:
  SurfaceImage(const SurfaceFrame& frame, std::shared_ptr<const SurfaceMesh> mesh, double device_pixel_ratio);

  /// Continues to paint for about `budget_ms`.
  void work(double budget_ms);
  bool isDone() const { return done_; }
  const QImage& image() const { return image_; }

 private:
  SurfaceFrame frame_;
  SurfaceAxes axes_;
  QImage image_;
  SurfacePainting painting_;
  bool done_ = false;
};

}  // namespace tactus::workbench
