// The way of the tube on a sagittal image: a smooth curve through clicked points, and depths along it (paper, Section
// 3.1.3, Fig. 4).
#pragma once

#include <vector>

#include "core/base/error.h"

namespace tactus::elicitation {

/// A place on an image, px from its left upper corner.
struct ImagePoint {
  double x = 0;
  double y = 0;

  bool operator==(const ImagePoint&) const = default;
};

/// Distance in px.
double distance(const ImagePoint& one, const ImagePoint& other);

/// The scale of an image on which the line from `one` to `other` is `length_mm` long. Returns an error for a length
/// that is not positive and finite, or points less than a pixel apart.
base::Result<double> mmPerPixel(const ImagePoint& one, const ImagePoint& other, double length_mm);

/// A natural cubic spline through points, over the lengths of its chords: no corners, and no overshoot where points are
/// evenly spread. Depth is the arc length from the first point, which is the nostril.
/// Thread: any. Real-time safe: no.
class TubePath {
 public:
  /// The curve through at least two `points`. Returns an error for fewer, a number that is not finite, two neighbors in
  /// the same place, or `mm_per_px` that is not positive and finite.
  static base::Result<TubePath> through(std::vector<ImagePoint> points, double mm_per_px);

  const std::vector<ImagePoint>& points() const { return points_; }
  double mmPerPx() const { return mm_per_px_; }
  double lengthMm() const { return lengths_mm_.back(); }
  /// The place at `depth_mm`, clamped to the path.
  ImagePoint at(double depth_mm) const;
  /// The direction of the way at `depth_mm`, a vector of length 1.
  ImagePoint direction(double depth_mm) const;
  /// The depth of the place of the path that is nearest to `place`.
  double depthNear(const ImagePoint& place) const;
  /// The depth of point `index`.
  double depthOfPoint(std::size_t index) const;
  /// The gap between two points in which the nearest place of the path lies: a new point belongs behind this index.
  std::size_t gapNear(const ImagePoint& place) const;
  /// The path as a line with a point at least every `step_mm`.
  std::vector<ImagePoint> outline(double step_mm) const;

 private:
  TubePath(std::vector<ImagePoint> points, double mm_per_px);
  /// The place for the parameter `t` of the piece `gap`, in [0, 1].
  ImagePoint place(std::size_t gap, double t) const;
  /// Its derivative.
  ImagePoint slope(std::size_t gap, double t) const;
  /// Arc length from the begin of `gap` to its parameter `t`, mm.
  double lengthIn(std::size_t gap, double t) const;
  struct Place {
    std::size_t gap;
    double t;
  };
  Place placeAt(double depth_mm) const;
  Place placeNear(const ImagePoint& near) const;

  std::vector<ImagePoint> points_;
  double mm_per_px_;
  std::vector<double> chords_px_;   ///< of each gap
  std::vector<ImagePoint> bends_;   ///< second derivatives at the points
  std::vector<double> lengths_mm_;  ///< arc length at each point
};

}  // namespace tactus::elicitation
