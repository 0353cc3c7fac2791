#include "app/workbench/tune/rules/rule_cell.h"

#include <algorithm>

namespace tactus::workbench {

RuleCell stepped(const RuleGridSizes& sizes, RuleCell from, int columns, int rows) {
  if (columns < 0 && from.column > 0) --from.column;
  if (columns > 0 && from.column + 1 < sizes.columns) ++from.column;
  if (rows > 0) {
    if (from.row + 1 < sizes.rows[from.grid]) {
      ++from.row;
    } else if (from.grid + 1 < sizes.rows.size()) {
      from = {from.grid + 1, 0, from.column};
    }
  }
  if (rows < 0) {
    if (from.row > 0) {
      --from.row;
    } else if (from.grid > 0) {
      from = {from.grid - 1, sizes.rows[from.grid - 1] - 1, from.column};
    }
  }
  return from;
}

RuleCell steppedGrid(const RuleGridSizes& sizes, RuleCell from, int count) {
  const auto last = static_cast<std::ptrdiff_t>(sizes.rows.size()) - 1;
  const auto grid =
      static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(from.grid) + count, 0, last));
  return {grid, std::min(from.row, sizes.rows[grid] - 1), from.column};
}

RuleCell nextToFill(const RuleGridSizes& sizes, RuleCell from) {
  if (from.column + 1 < sizes.columns) return {from.grid, from.row, from.column + 1};
  if (from.row + 1 < sizes.rows[from.grid]) return {from.grid, from.row + 1, 0};
  if (from.grid + 1 < sizes.rows.size()) return {from.grid + 1, 0, 0};
  return from;
}

}  // namespace tactus::workbench
