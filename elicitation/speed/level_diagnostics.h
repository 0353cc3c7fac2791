// How far the speeds of one participant can be trusted to tell the levels apart.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/fuzzy/force_model.h"
#include "core/study/records.h"
#include "elicitation/speed/level_confusion.h"
#include "elicitation/speed/level_speeds.h"
#include "elicitation/speed/level_trend.h"

namespace tactus::elicitation {

struct LevelDiagnostics {
  std::vector<LevelSpeeds> levels;                 ///< slow to fast
  std::vector<std::optional<double>> separations;  ///< d' of each level and the next (level_speeds.h)
  std::optional<LevelTrend> trend;                 ///< of the means of the strokes; absent with fewer than two levels
  LevelConfusion confusion;
  std::vector<std::string> warnings;  ///< one sentence each, naming the participant and the numbers
};

/// Diagnoses one participant's samples against `centres` (ascending, one per level of `levels`, which go from slow to
/// fast). Warned of: what levelConfusion warns of, d' below 1, a centre outside the mean ± SD of its level, and strokes
/// whose means do not rise with the level (p above 0.05, where the strokes are enough to show it).
LevelDiagnostics levelDiagnostics(std::span<const study::SpeedSample> samples, std::span<const std::string> levels,
                                  std::span<const double> centres, const std::string& participant);

/// Place of the term of `speed` with the largest membership at `speed_mm_s` (clamped to the universe); on a tie the
/// lower one. `speed` has at least one term.
std::size_t termAt(const fuzzy::Variable& speed, double speed_mm_s);

/// The sentence that the means of all levels read as one and the same term of `averaged`, and how they read with the
/// participant's `own` terms; nothing where they do not, or where only one level has samples.
std::optional<std::string> sameTermNote(std::span<const LevelSpeeds> levels, const fuzzy::Variable& averaged,
                                        const fuzzy::Variable& own, const std::string& participant);

}  // namespace tactus::elicitation
