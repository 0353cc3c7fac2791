// Checks that the speeds, depths and times of strokes in a table are in mm/s, mm and s.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/study/data_finding.h"
#include "experiments/table_strokes.h"

namespace tactus::experiments {

/// The factors that convert the columns of a stroke to s, mm and mm/s.
struct UnitFactors {
  double time = 1;
  double depth = 1;
  double speed = 1;

  bool operator==(const UnitFactors&) const = default;
};

/// The consistency of one stroke's columns: the depth must change as the speeds say.
struct UnitFit {
  enum class Verdict {
    kUnknown,  ///< too few rows, or constant times or depths
    kFits,     ///< speed and change of depth within a factor of 1.5
    kOther,    ///< exactly one other unit makes it fit
    kNeither,  ///< no usual unit makes it fit
  };
  Verdict verdict = Verdict::kUnknown;
  UnitFactors factors;          ///< kOther only
  double depth_over_speed = 1;  ///< change of depth divided by the integral of the speeds; may be negative
};

/// Checks a stroke of a table against plausible values: 0.05 to 120 s, 3 to 1000 mm, 1 to 2000 mm/s in the median.
/// Another unit is assumed only if these limits hold with it, and if time or speed violate them without it or the
/// depths contradict the speeds.
UnitFit unitFit(const TableStroke& stroke);

/// Findings about the units of one participant's strokes. Impossible units are kRefused.
std::vector<study::DataFinding> unitFindings(std::span<const TableStroke* const> strokes);

/// Findings about participants with consistent columns but another scale:
/// - strokes under 8 mm and speeds under 15 mm/s (under 8 mm/s if depths give no information);
/// - strokes at least 5 times as long as those of every other participant, or at most a fifth;
/// - speeds at least 8 times theirs, or at most an eighth.
std::vector<study::DataFinding> scaleFindings(std::span<const std::vector<const TableStroke*>> participants);

}  // namespace tactus::experiments
