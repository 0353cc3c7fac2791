// Diagnostics of one participant: how well the speeds separate the levels.
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
  std::optional<LevelTrend> trend;                 ///< of the stroke means; empty for fewer than two levels
  LevelConfusion confusion;
  std::vector<std::string> warnings;  ///< one sentence each, naming the participant and the numbers
};

/// Diagnoses one participant's samples against `centres` (ascending, one per level). `levels`: slow to fast. Warns for:
/// the warnings of levelConfusion, d' below 1, a center outside the mean ± SD of its level, stroke means that do not
/// rise with the level (p above 0.05, if there are enough strokes to show it).
LevelDiagnostics levelDiagnostics(std::span<const study::SpeedSample> samples, std::span<const std::string> levels,
                                  std::span<const double> centres, const std::string& participant);

/// Index of the term of `speed` with the largest membership at `speed_mm_s` (clamped to the universe); on a tie the
/// lower one. `speed`: at least one term.
std::size_t termAt(const fuzzy::Variable& speed, double speed_mm_s);

/// A sentence saying that the means of all levels belong to one and the same term of `averaged`, and their terms in the
/// participant's `own` terms. Nothing if that is not so, or if only one level has samples.
std::optional<std::string> sameTermNote(std::span<const LevelSpeeds> levels, const fuzzy::Variable& averaged,
                                        const fuzzy::Variable& own, const std::string& participant);

}  // namespace tactus::elicitation
