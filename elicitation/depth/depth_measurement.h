// A measurement of depths on a sagittal image, as a study keeps it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "elicitation/depth/tube_path.h"

namespace tactus::elicitation {

// The terms of the insertion depth from the boundaries of regions along the tube (paper, Section 3.1.3, Fig. 3c).

/// The boundary between a region and the next one.
struct DepthBoundary {
  double depth_mm = 0;         ///< along the path, of the person on the image
  double half_overlap_mm = 0;  ///< the terms cross here and end this far before and behind, >= 0

  bool operator==(const DepthBoundary&) const = default;
};

/// The scale factor of a person as tall as the one on the image; 0.93 fits a small or female adult, 1.05 a large one
/// (facts: 1.3).
inline constexpr double kSameAnatomy = 1;

/// The terms of `depth`, whose ids and labels stay, with trapezoids whose ramps cross at the boundaries, all depths
/// times `scale`. The first and the last term have shoulders at the ends of the universe, which stays. One boundary
/// fewer than terms.
/// Returns an error that names the regions for: another number of boundaries, a scale outside 0.5 to 2, boundaries that
/// do not rise, overlaps that reach into each other, ramps that do not end inside the universe.
base::Result<std::vector<fuzzy::Term>> depthTerms(const fuzzy::Variable& depth,
                                                  std::span<const DepthBoundary> boundaries,
                                                  double scale = kSameAnatomy);

/// The boundaries of `terms`, trapezoids whose neighbors' ramps cross: where they cross, and half of their overlap.
std::vector<DepthBoundary> boundariesOf(std::span<const fuzzy::Term> terms);

/// The scale of the sagittal image of the Visible Human that the paper used (Section 3.1.3).
inline constexpr double kVisibleHumanMmPerPx = 0.33;

struct DepthMeasurement {
  std::string image;     ///< name of the image for people; empty: none was loaded
  bool example = false;  ///< the image is the anatomy drawing of the program
  double mm_per_px = kVisibleHumanMmPerPx;
  std::vector<ImagePoint> path;           ///< the points that were clicked, from the entry; may be too few for a path
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

// Depth terms of a study whose regions were measured on an image: the boundaries of the measurement, the regions of the
// form.

/// Where the boundaries of the regions along the tube come from.
enum class DepthsFrom {
  kTemplate,  ///< the sets of the procedure
  kMeasured,  ///< the study's measurement on an image
};

/// `template`, `measured`: the values of `tactus build --depths`.
std::string_view name(DepthsFrom from) noexcept;

/// The terms `set` with measured depths. `depth`: the depth with all regions, in the order of the measurement's
/// boundaries; `set` has some of them. A term ends at the end of its region; a region that `set` lacks belongs to the
/// term behind it, or at the end to the term before it, as in the sets of the procedure.
/// Returns the errors of depthTerms.
base::Result<std::vector<fuzzy::Term>> measuredTerms(const DepthMeasurement& measurement, const fuzzy::Variable& depth,
                                                     const std::vector<fuzzy::Term>& set);

/// One sentence: on which image the depths were measured, at which scale.
std::string measuredSentence(const DepthMeasurement& measurement);

}  // namespace tactus::elicitation
