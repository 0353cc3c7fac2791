// Detects strokes in a table that are copies of other strokes.
#pragma once

#include <span>
#include <vector>

#include "core/study/data_finding.h"
#include "experiments/table_strokes.h"

namespace tactus::experiments {

/// Findings about copied strokes, one for each participant at most, who comes after the original in the table. A stroke
/// counts as copied if it has 8 rows or more with 5 different speeds or more, and
/// - the same speeds as another stroke, row for row, or
/// - the same speeds but for a constant, as all strokes of the same level and number of another participant (two or
///   more), or
/// - the rows of another stroke, some of them left out (20 or more), with a constant in times and in depths or none, or
/// - speeds that differ by a lag of at most 0.3 s and noise of at most 3 % of their spread, again for all strokes of
///   another participant, six or more.
std::vector<study::DataFinding> strokeCopyFindings(std::span<const TableStroke> strokes);

}  // namespace tactus::experiments
