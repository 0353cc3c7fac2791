// The anatomy picture of the bench: the tube at its depth, and the region of the model in which its tip is lit. The
// regions are those of the model's depth terms, not of anatomy.
#pragma once

#include <optional>
#include <vector>

#include "app/workbench/anatomy/anatomy_view.h"
#include "app/workbench/anatomy/anatomy.h"
#include "app/workbench/feel/depth_regions.h"
#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

/// How the neck is drawn at `value` of its flexion: the first word upright, the last chin on chest, those between half
/// flexed.
anatomy::Posture drawnPosture(const fuzzy::Variable& neck_flexion, double value);

class TubePicture : public anatomy::AnatomyView {
  Q_OBJECT

 public:
  explicit TubePicture(QWidget* parent = nullptr);

  void setRegions(std::vector<DepthRegion> regions);
  /// Depth of the tip, mm.
  void setTip(double depth_mm);
  /// The region of the tip; empty in front of the nose and outside all regions.
  QString regionText() const;
  /// Moves the head within one second, as the force changes; at once the first time.
  void setNeck(anatomy::Posture posture);

 private:
  void showTip();

  std::vector<DepthRegion> regions_;
  double depth_mm_ = 0;
  bool placed_ = false;  ///< the neck has a posture
};

}  // namespace tactus::workbench
