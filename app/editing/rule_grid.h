// The rules of one expert as the grids of the questionnaire (paper, Table A1): one condition against the region of the
// tube's tip, five force words in the cells.
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

/// A cell by the terms that it is about.
struct CellPlace {
  std::string condition_term;
  std::string region_term;
};

/// What the rules with exactly the two conditions of a cell say.
struct GridCell {
  std::optional<std::size_t> rule;  ///< the one that is shown: the first enabled one of a weight > 0, else the first
  std::string then;                 ///< its consequent; empty without a rule
  double weight = 1;
  bool enabled = true;
  bool conflict = false;  ///< further rules with these conditions count too, with another consequent
};

struct RuleGrid {
  std::vector<std::string> rows;     ///< term ids of the condition, as the expert understands them
  std::vector<std::string> columns;  ///< term ids of the region
  std::vector<GridCell> cells;       ///< row by row

  const GridCell& at(std::size_t row, std::size_t column) const { return cells[row * columns.size() + column]; }
};

/// The grids of an expert: every input but the region's against it.
std::vector<GridId> gridsOf(const fuzzy::ForceModel& model, const std::string& expert, const std::string& region);

/// Refused: an unknown expert or input, the same input twice.
base::Result<RuleGrid> ruleGrid(const fuzzy::ForceModel& model, const GridId& grid);

/// Answers a cell with the output term `then`; nothing takes its rules away. A cell without a rule gets one of weight
/// 1, placed among the rules of the grids in the order of the form: by condition, its term, the region. A rule that is
/// there is enabled and keeps a weight > 0; a cell with several rules keeps one.
base::Result<Edit> setAnswer(const fuzzy::ForceModel& model, const GridId& grid, const CellPlace& cell,
                             const std::optional<std::string>& then);

}  // namespace tactus::editing
