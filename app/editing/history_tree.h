// The history as rows from top to bottom: the line on which undo and redo move, and the branches beside it.
#pragma once

#include <vector>

#include "app/editing/edit_history.h"

namespace tactus::editing {

/// One state of the model.
struct HistoryRow {
  enum class Place {
    kDone,  ///< on the way to the current state
    kCurrent,
    kUndone,  ///< redo leads there
    kBranch,  ///< left by an edit after an undo; it can be returned to
  };
  StateId state = 0;
  Place place = Place::kDone;
  std::size_t level = 0;           ///< how far it is indented: a branch is one level deeper than the state it leaves
  bool starts = false;             ///< nothing above it on its own level belongs to it
  bool goes_on = false;            ///< further rows of its own level belong to it
  std::vector<std::size_t> marks;  ///< indices of the events that named or signed it, the oldest first
};

/// Every state once. A branch stands between the state it leaves and the state that follows that one.
std::vector<HistoryRow> historyRows(const EditHistory& history);

}  // namespace tactus::editing
