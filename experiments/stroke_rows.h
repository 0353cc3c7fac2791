// Whether the rows of strokes in a table stand in the order of time, each once.
#pragma once

#include <span>
#include <vector>

#include "core/study/data_finding.h"
#include "experiments/table_strokes.h"

namespace tactus::experiments {

/// How the rows of one stroke stand.
enum class RowOrder {
  kRising,     ///< times rise or stay
  kNoTimes,    ///< all times are one
  kBackwards,  ///< times fall from the first row to the last
  kTwice,      ///< a fifth of the rows or more are exact repetitions
  kRestarts,   ///< times begin again, or two depths 2 mm apart or more have one time: two strokes under one number
  kUnsorted,
};

RowOrder rowOrder(const TableStroke& stroke);

/// Findings about the rows of one participant's strokes: one sentence for each kind of disorder.
std::vector<study::DataFinding> rowFindings(std::span<const TableStroke* const> strokes);

}  // namespace tactus::experiments
