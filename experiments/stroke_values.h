// Whether the speeds and depths in a table can be those of strokes: which levels there are, values that stand out.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/study/data_finding.h"
#include "experiments/table_strokes.h"

namespace tactus::experiments {

/// Findings about the values of one participant's strokes: strokes under 30 mm and half of the usual length, gaps of
/// 0.05 s and five steps, single depths 50 mm from their neighbors, speeds that never change, speeds 5 times above the
/// 95 % quantile of their level and codes for missing values, ways back (5 mm of depth, or speeds that stay below 0,
/// -10 mm/s on the mean, for a twentieth of the rows), depths that never change.
std::vector<study::DataFinding> valueFindings(std::span<const TableStroke* const> strokes);

/// Findings about the levels of one participant's strokes. `levels`: the known ids, slowest first. An unknown level is
/// refused; a known one without strokes, one with fewer strokes than `usual`, and levels whose mean speeds fall by a
/// tenth or more are named.
std::vector<study::DataFinding> levelFindings(std::span<const TableStroke* const> strokes,
                                              std::span<const std::string> levels, std::size_t usual);

/// The number of strokes that most participants have at most levels; the larger on a tie.
std::size_t usualStrokes(std::span<const TableStroke> strokes);

}  // namespace tactus::experiments
