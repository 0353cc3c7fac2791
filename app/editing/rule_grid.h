// The rules of one expert as the grids of the questionnaire (paper, Table A1). Each grid crosses one condition with the
// region of the tube's tip; the cells hold five force words.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/editing/edit.h"
#include "core/base/error.h"
#include "core/fuzzy/force_model.h"

namespace tactus::editing {

// Rules as text, one a line, to copy and paste them as a block:
//   IF Tube lubrication is Well AND Insertion depth is Stomach THEN Resistive force is Small WITH 0.5
//   OFF IF Speed is Fast THEN Resistive force is Large

/// The rules `indices` of `expert`, with the labels of the model. A weight other than 1 follows behind WITH; a disabled
/// rule begins with OFF. `rulesFromText` reads the same rules again.
std::string rulesAsText(const fuzzy::ForceModel& model, const fuzzy::Expert& expert,
                        std::span<const std::size_t> indices);

/// Reads such text: labels or ids, in any case, with any spaces between the words; empty lines are skipped. One line
/// that is no rule refuses all of them, and the error names the line and what it does not know.
base::Result<std::vector<fuzzy::Rule>> rulesFromText(const fuzzy::ForceModel& model, const fuzzy::Expert& expert,
                                                     std::string_view text);

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
