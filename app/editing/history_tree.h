// The history as rows from top to bottom: the line of undo and redo, and the branches beside it.
#pragma once

#include <vector>

#include "app/editing/edit_history.h"

namespace tactus::editing {

/// One state of the model.
struct HistoryRow {
  enum class Place {
    kDone,  ///< on the way to the current state
    kCurrent,
    kUndone,  ///< redo leads to it
    kBranch,  ///< left by an edit after an undo; the user can return to it
  };
  StateId state = 0;
  Place place = Place::kDone;
  std::size_t level = 0;           ///< depth of the indent: a branch is one level deeper than its parent state
  bool starts = false;             ///< first row of its level in this run
  bool goes_on = false;            ///< more rows of its level follow
  std::vector<std::size_t> marks;  ///< indices of the events that named or signed it, oldest first
};

/// Every state once. A branch stands between its parent state and the next state of the line.
std::vector<HistoryRow> historyRows(const EditHistory& history);

}  // namespace tactus::editing
