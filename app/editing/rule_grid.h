// The rules of one expert as the grids of the questionnaire (paper, Table A1). Each grid crosses one condition with the
// region of the tube's tip; the cells hold five force words.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/editing/edit.h"

namespace tactus::editing {

/// One grid: the inputs that it crosses.
struct GridId {
  std::string expert;
  std::string condition;  ///< input of the rows, e.g. `lubrication`
  std::string region;     ///< input of the columns, e.g. `depth`
};

/// A cell, named by its two terms.
struct CellPlace {
  std::string condition_term;
  std::string region_term;
};

/// The content of a cell: the rules with exactly its two conditions.
struct GridCell {
  std::optional<std::size_t> rule;  ///< the shown rule: the first one that counts (enabled, weight > 0), else the first
                                    ///< one
  std::string then;                 ///< its consequent; empty without a rule
  double weight = 1;
  bool enabled = true;
  bool conflict = false;  ///< further rules with these conditions count and have another consequent
};

struct RuleGrid {
  std::vector<std::string> rows;     ///< term ids of the condition, from the expert's list
  std::vector<std::string> columns;  ///< term ids of the region
  std::vector<GridCell> cells;       ///< row by row

  const GridCell& at(std::size_t row, std::size_t column) const { return cells[row * columns.size() + column]; }
};

/// The grids of an expert: one for every input but `region`, crossed with `region`.
std::vector<GridId> gridsOf(const fuzzy::ForceModel& model, const std::string& expert, const std::string& region);

/// Refused: an unknown expert or input, the same input twice.
base::Result<RuleGrid> ruleGrid(const fuzzy::ForceModel& model, const GridId& grid);

/// Answers a cell with the output term `then`; nothing removes its rules. A cell without a rule gets one of weight 1.
/// Its place among the grid rules is the order of the form: by condition, then its term, then the region. An existing
/// rule is enabled and keeps a weight > 0; a cell with several rules keeps one.
base::Result<Edit> setAnswer(const fuzzy::ForceModel& model, const GridId& grid, const CellPlace& cell,
                             const std::optional<std::string>& then);

}  // namespace tactus::editing
