// Checks that the rows of strokes in a table are in time order, without duplicates.
#pragma once

#include <span>
#include <vector>

#include "core/study/data_finding.h"
#include "experiments/table_strokes.h"

namespace tactus::experiments {

/// The order of the rows of one stroke.
enum class RowOrder {
  kRising,     ///< times never fall
  kNoTimes,    ///< all times are equal
  kBackwards,  ///< times fall from the first row to the last
  kTwice,      ///< at least a fifth of the rows are exact duplicates
  kRestarts,   ///< times start again, or depths at least 2 mm apart have the same time: two strokes with one number
  kUnsorted,
};

RowOrder rowOrder(const TableStroke& stroke);

/// Findings about the rows of one participant's strokes: one sentence per kind of disorder.
std::vector<study::DataFinding> rowFindings(std::span<const TableStroke* const> strokes);

}  // namespace tactus::experiments
