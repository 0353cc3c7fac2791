// How much tube a person needs: bedside formulas, and the depth that the tip should reach.
#pragma once

#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "elicitation/depth/depth_measurement.h"

namespace tactus::elicitation {

/// A distance from `from_mm` to `to_mm`, both ends included.
struct DepthRange {
  double from_mm = 0;
  double to_mm = 0;
};

/// Which formula gave a length.
enum class LengthFormula {
  kNoseEarXiphoid,  ///< the length itself: nose tip to ear lobe to xiphoid
  kHanson,          ///< 0.38696 NEX + 303.7 mm (Hanson 1979)
  kCorrected,       ///< 0.38696 NEX + 363.7 mm: the corrected length, 60 mm beyond Hanson's
};
/// `nose_ear_xiphoid`, `hanson`, `corrected`.
std::string_view name(LengthFormula formula) noexcept;

/// The length that one formula gives for a person, and where its tip ends up.
struct InsertionLength {
  LengthFormula formula = LengthFormula::kNoseEarXiphoid;
  double length_mm = 0;
  double beyond_sphincter_mm = 0;  ///< below 0: the tip stays in the esophagus
  bool in_target = false;
};

/// The range for a nose-ear-xiphoid length of adults that is accepted, in mm. Outside, the unit is probably another
/// one.
inline constexpr DepthRange kNoseEarXiphoidMm{300, 800};

/// The lower esophageal sphincter of the usual anatomy, 440 mm from the nostril: the end of the esophagus in the
/// default terms (medians of manometry: upper border 415, length 30 mm).
inline constexpr double kSphincterMm = 440;

/// Where the tip should lie: 30 to 100 mm beyond the lower esophageal sphincter (Boeykens 2023, Crit Care 27:317), with
/// the sphincter at `sphincter_mm` times `scale` (kSameAnatomy in depth_measurement.h).
DepthRange targetDepth(double scale = kSameAnatomy, double sphincter_mm = kSphincterMm);

/// The three lengths for a nose-ear-xiphoid length `nex_mm`. The plain length is too short in 96.7 % of people when
/// gauged by the tip (Chen 2014, PMC3919749). Head tilt can change the needed length by up to 50 mm. Returns an error
/// for a length outside kNoseEarXiphoidMm, or a scale outside 0.5 to 2.
base::Result<std::vector<InsertionLength>> insertionLengths(double nex_mm, double scale = kSameAnatomy,
                                                            double sphincter_mm = kSphincterMm);

}  // namespace tactus::elicitation
