// A cell of the rule grids, and the ways from one to another.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace tactus::workbench {

/// A cell of the grids, which stand above each other.
struct RuleCell {
  std::size_t grid = 0;
  std::size_t row = 0;
  std::size_t column = 0;

  bool operator==(const RuleCell&) const = default;
};

/// How many cells there are. Every grid has a row at least, and there is a column at least.
struct RuleGridSizes {
  std::vector<std::size_t> rows;  ///< of each grid
  std::size_t columns = 0;        ///< of all

  bool has(const RuleCell& cell) const {
    return cell.grid < rows.size() && cell.row < rows[cell.grid] && cell.column < columns;
  }
  /// Nothing where there is no grid.
  std::optional<RuleCell> first() const { return rows.empty() ? std::nullopt : std::optional(RuleCell()); }
};

// `from` is a cell of `sizes` in all of these.

/// One cell on as the arrow keys go: from grid to grid, not beyond the ends. The signs of `columns` and `rows` count.
RuleCell stepped(const RuleGridSizes& sizes, RuleCell from, int columns, int rows);
/// The same cell `count` grids further down, or of the last one.
RuleCell steppedGrid(const RuleGridSizes& sizes, RuleCell from, int count);
/// The next cell as they are filled in: along the row, then the next row, then the next grid; the last one itself.
RuleCell nextToFill(const RuleGridSizes& sizes, RuleCell from);

}  // namespace tactus::workbench
