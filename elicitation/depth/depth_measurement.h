// A measurement of depths on a sagittal image, as a study keeps it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "elicitation/depth/depth_terms.h"
#include "elicitation/depth/tube_path.h"

namespace tactus::elicitation {

/// The scale of the sagittal image of the Visible Human that the paper used (Section 3.1.3).
inline constexpr double kVisibleHumanMmPerPx = 0.33;

struct DepthMeasurement {
  std::string image;     ///< name of the image for people; empty: none was loaded
  bool example = false;  ///< the image is the anatomy drawing of the program
  double mm_per_px = kVisibleHumanMmPerPx;
  std::vector<ImagePoint> path;           ///< the points that were clicked, from the nostril; may be too few for a path
  std::vector<DepthBoundary> boundaries;  ///< between the regions in their order
  double scale = kSameAnatomy;            ///< of the person for whom the terms are; the image's person is 1
  /// Nose tip to ear lobe to xiphoid, of that person (insertion_length.h).
  std::optional<double> nose_ear_xiphoid_mm;

  bool operator==(const DepthMeasurement&) const = default;
};

/// Without an image or a path, with the boundaries of the terms of `depth`.
DepthMeasurement emptyMeasurement(const fuzzy::Variable& depth);

/// JSON text of `measurement`, on one line.
std::string toText(const DepthMeasurement& measurement);

/// Reads the text of a study file. Unknown keys are ignored. Returns an error with the place for a text that is no
/// measurement.
base::Result<DepthMeasurement> readMeasurement(std::string_view text);

}  // namespace tactus::elicitation
