// How alike two strokes of a table are: the same rows, some of them, or the same motion a little later.
#pragma once

#include <optional>
#include <vector>

#include "experiments/table_strokes.h"

namespace tactus::experiments {

/// A stroke as numbers to compare. It views the stroke.
struct StrokeNumbers {
  const TableStroke* stroke = nullptr;
  std::vector<double> mm_s;    ///< speeds, row after row
  std::vector<double> time_s;  ///< of the rows
  double mean = 0;             ///< of the speeds
  double spread = 0;           ///< standard deviation of the speeds
  double largest = 0;          ///< speed
  bool in_time = false;        ///< times rise from row to row
};

/// Nothing for a stroke that says too little: fewer than 8 rows, or than 5 different speeds.
std::optional<StrokeNumbers> numbersOf(const TableStroke& stroke);

enum class Likeness {
  kNone,
  kNoisy,    ///< speeds that differ by noise of at most 3 % of their spread, and by a constant
  kShifted,  ///< by a constant alone
  kPart,     ///< rows of the one are missing in the other
  kSame,     ///< the same speeds, row for row
};

/// Row by row, for as many rows; otherwise kNone.
Likeness rowLikeness(const StrokeNumbers& a, const StrokeNumbers& b);

/// Whether the stroke with fewer rows (20 or more, half of the other's or more) is the other one with rows left out:
/// each of its rows has its time, depth and speed, but for a constant in times and in depths.
bool isPart(const StrokeNumbers& a, const StrokeNumbers& b);

/// Whether the speeds are the same over time but for a lag of at most 0.3 s, a constant, and noise of at most 3 % of
/// their spread, while four fifths of the longer stroke are compared.
bool isSameMotion(const StrokeNumbers& a, const StrokeNumbers& b);

}  // namespace tactus::experiments
