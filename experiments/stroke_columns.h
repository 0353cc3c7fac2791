// Whether two columns of a table of strokes stand under each other's names.
#pragma once

#include <optional>
#include <span>

#include "core/study/data_finding.h"
#include "experiments/table_strokes.h"

namespace tactus::experiments {

/// Refused: strokes of one participant, most of which make no sense as they stand, while time, depth and speed fit each
/// other in three quarters of them, two or more, once two of the columns are exchanged.
std::optional<study::DataFinding> swappedColumns(std::span<const TableStroke* const> strokes);

}  // namespace tactus::experiments
