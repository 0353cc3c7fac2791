// A cell of the rule grids, and the moves between cells.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace tactus::workbench {

/// A cell of the grids. The grids stand one above the other.
struct RuleCell {
  std::size_t grid = 0;
  std::size_t row = 0;
  std::size_t column = 0;

  bool operator==(const RuleCell&) const = default;
};

/// The numbers of cells. Every grid has at least one row, and there is at least one column.
struct RuleGridSizes {
  std::vector<std::size_t> rows;  ///< per grid
  std::size_t columns = 0;        ///< of every grid

  bool has(const RuleCell& cell) const {
    return cell.grid < rows.size() && cell.row < rows[cell.grid] && cell.column < columns;
  }
  /// The first cell; nothing if there is no grid.
  std::optional<RuleCell> first() const { return rows.empty() ? std::nullopt : std::optional(RuleCell()); }
};

// In all these functions `from` is a cell of `sizes`.

/// The next cell for an arrow key: crosses from grid to grid, stops at the ends. Only the signs of `columns` and `rows`
/// count.
RuleCell stepped(const RuleGridSizes& sizes, RuleCell from, int columns, int rows);
/// The same cell `count` grids below, or in the last grid.
RuleCell steppedGrid(const RuleGridSizes& sizes, RuleCell from, int count);
/// The next cell in the order of filling in: along the row, then the next row, then the next grid. The last cell
/// returns itself.
RuleCell nextToFill(const RuleGridSizes& sizes, RuleCell from);

}  // namespace tactus::workbench
