// The path of the tube in the drawing. Its length from the nostril is the depth of the model.
#pragma once

#include <QPointF>
#include <vector>

namespace tactus::workbench::anatomy {

class TubeWay {
 public:
  /// The path with the neck flexed by `flexion_deg`. A place keeps the depth that it has in the upright head, so that a
  /// landmark has one depth in every posture; the drawn path to it gets a little shorter.
  explicit TubeWay(double flexion_deg);

  /// The tip at `depth_mm` from the nostril; below 0 it is in front of the nose. Clamped to the path.
  QPointF placeAt(double depth_mm) const;
  /// The path from one depth to another, both clamped, `from_mm` < `to_mm`.
  std::vector<QPointF> between(double from_mm, double to_mm) const;
  /// The drawn length from the nostril to `depth_mm`, mm.
  double drawnLengthMm(double depth_mm) const;

  double beginMm() const { return depths_.front(); }
  double endMm() const { return depths_.back(); }

 private:
  std::vector<QPointF> line_;
  std::vector<double> depths_;  ///< of each point of the line, in the upright head
};

}  // namespace tactus::workbench::anatomy
