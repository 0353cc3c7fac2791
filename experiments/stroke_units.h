// Whether the speeds, depths and times of strokes in a table are in mm/s, mm and s.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/study/data_finding.h"
#include "experiments/table_strokes.h"

namespace tactus::experiments {

/// What the columns of a stroke would have to be multiplied by to be in s, mm and mm/s.
struct UnitFactors {
  double time = 1;
  double depth = 1;
  double speed = 1;

  bool operator==(const UnitFactors&) const = default;
};

/// How the columns of one stroke fit each other: the depth must change as the speed says.
struct UnitFit {
  enum class Verdict {
    kUnknown,  ///< too few rows, or times or depths that do not change
    kFits,     ///< speed and change of depth within a factor of 1.5
    kOther,    ///< another unit makes it fit, and only one
    kNeither,  ///< no usual unit does
  };
  Verdict verdict = Verdict::kUnknown;
  UnitFactors factors;          ///< kOther only
  double depth_over_speed = 1;  ///< change of depth divided by what the speeds add up to; may be negative
};

/// A stroke as the tables hold it: 0.05 to 120 s, 3 to 1000 mm, 1 to 2000 mm/s on the median. Another unit is taken
/// only where these hold with it, and time or speed do not without, or the depths contradict the speeds.
UnitFit unitFit(const TableStroke& stroke);

/// Findings about the units of one participant's strokes: units that cannot be meant are refused.
std::vector<study::DataFinding> unitFindings(std::span<const TableStroke* const> strokes);

/// Findings about participants whose columns fit each other, and yet are of another scale: strokes under 8 mm and
/// speeds under 15 mm/s (under 8 mm/s where depths say nothing), strokes 5 times as long as those of every other
/// participant, or a fifth, or speeds 8 times theirs, or an eighth.
std::vector<study::DataFinding> scaleFindings(std::span<const std::vector<const TableStroke*>> participants);

}  // namespace tactus::experiments
