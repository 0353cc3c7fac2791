// The rows of a table of speeds, grouped by stroke.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/study/data_finding.h"
#include "core/study/records.h"

namespace tactus::experiments {

/// One stroke of a table. It refers to the samples from which it was made.
struct TableStroke {
  std::string_view participant;
  std::string_view level;
  int number = 0;
  std::vector<const study::SpeedSample*> rows;     ///< in the order of the table
  std::vector<const study::SpeedSample*> in_time;  ///< sorted by time, without exact duplicates of a row

  study::TableLine line() const { return rows.front()->line; }
  /// `stroke 2 at slow`, for sentences.
  std::string name() const { return "stroke " + std::to_string(number) + " at " + std::string(level); }
};

/// All strokes, in the order of their first rows, with at least one row each. `samples` must outlive the result.
std::vector<TableStroke> tableStrokes(std::span<const study::SpeedSample> samples);

/// The strokes of each participant, in the order of their first rows.
std::vector<std::vector<const TableStroke*>> byParticipant(std::span<const TableStroke> strokes);

/// Names of strokes for a sentence, e.g. `stroke 1 at slow`, `3 strokes at slow`, `all 12 strokes`. `of`: the number of
/// all strokes.
std::string strokesText(std::span<const TableStroke* const> strokes, std::size_t of);

// Checks that the rows of strokes in a table are in time order, without duplicates.

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

// Whether two columns of a table of strokes stand under each other's names.

/// Refused: strokes of one participant, most of which make no sense as they stand, while time, depth and speed fit each
/// other in three quarters of them, two or more, once two of the columns are exchanged.
std::optional<study::DataFinding> swappedColumns(std::span<const TableStroke* const> strokes);

}  // namespace tactus::experiments
