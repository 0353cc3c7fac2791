// Checks the levels and the values of strokes in a table: unknown levels, implausible speeds and depths.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/study/data_finding.h"
#include "experiments/table_strokes.h"

namespace tactus::experiments {

/// Findings about the values of one participant's strokes:
/// - strokes under 30 mm and under half of the usual length;
/// - gaps above 0.05 s and five steps;
/// - single depths 50 mm from their neighbors;
/// - constant speeds, constant depths;
/// - speeds 5 times above the 95 % quantile of their level, and codes for missing values;
/// - backward motion: 5 mm of depth, or speeds that stay below 0, at -10 mm/s on average, for a twentieth of the rows.
std::vector<study::DataFinding> valueFindings(std::span<const TableStroke* const> strokes);

/// Findings about the levels of one participant's strokes. `levels`: the known ids, slowest first. An unknown level is
/// kRefused. Other findings: a known level without strokes, or with fewer than `usual`, and levels whose mean speeds
/// fall by a tenth or more.
std::vector<study::DataFinding> levelFindings(std::span<const TableStroke* const> strokes,
                                              std::span<const std::string> levels, std::size_t usual);

/// The number of strokes per level that is most frequent over participants and levels; on a tie the larger one.
std::size_t usualStrokes(std::span<const TableStroke> strokes);

}  // namespace tactus::experiments
