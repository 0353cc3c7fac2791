#include "app/workbench/tune/rules/rule_grid_geometry.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "app/workbench/base/theme.h"

namespace tactus::workbench {
namespace {

constexpr double kGap = 3;           // px, between cells
constexpr double kGridGap = 6;       // px, above the title of a grid
constexpr double kTallestRow = 3.5;  // lines of text; a taller cell only moves the words apart

double headHeight(const RuleGridGeometry::Needs& needs) { return 2 * needs.line + 4; }
double titleHeight(const RuleGridGeometry::Needs& needs) { return needs.line + 4 + kGridGap; }
// Two lines, so that a bar fits below a word.
double smallestRow(const RuleGridGeometry::Needs& needs) { return 2 * needs.line + kGap; }

std::size_t allRows(const RuleGridGeometry::Needs& needs) {
  return std::accumulate(needs.rows.begin(), needs.rows.end(), std::size_t{0});
}

double fixedHeight(const RuleGridGeometry::Needs& needs) {
  return headHeight(needs) + static_cast<double>(needs.rows.size()) * titleHeight(needs);
}

}  // namespace

RuleGridGeometry::RuleGridGeometry(Needs needs, QSizeF room) : needs_(std::move(needs)), width_(room.width()) {
  const auto columns = static_cast<double>(std::max<std::size_t>(1, needs_.columns));
  const auto rows = static_cast<double>(std::max<std::size_t>(1, allRows(needs_)));
  cell_width_ = std::max(needs_.cell, (room.width() - needs_.row_head) / columns);
  cell_height_ = std::clamp((room.height() - fixedHeight(needs_)) / rows, smallestRow(needs_),
                            std::max(smallestRow(needs_), kTallestRow * needs_.line));
}

QSizeF RuleGridGeometry::smallest(const Needs& needs) {
  return {needs.row_head + needs.cell * static_cast<double>(needs.columns),
          fixedHeight(needs) + smallestRow(needs) * static_cast<double>(allRows(needs))};
}

double RuleGridGeometry::rowTop(std::size_t grid, std::size_t row) const {
  const auto before =
      std::accumulate(needs_.rows.begin(), needs_.rows.begin() + static_cast<std::ptrdiff_t>(grid), row);
  return headHeight(needs_) + static_cast<double>(grid + 1) * titleHeight(needs_) +
         cell_height_ * static_cast<double>(before);
}

QRectF RuleGridGeometry::cell(const RuleCell& cell) const {
  return {needs_.row_head + cell_width_ * static_cast<double>(cell.column), rowTop(cell.grid, cell.row),
          cell_width_ - kGap, cell_height_ - kGap};
}

QRectF RuleGridGeometry::columnHead(std::size_t column) const {
  return {needs_.row_head + cell_width_ * static_cast<double>(column), 0, cell_width_, headHeight(needs_)};
}

QRectF RuleGridGeometry::corner() const { return {0, 0, needs_.row_head - theme::kGrid, headHeight(needs_)}; }

QRectF RuleGridGeometry::title(std::size_t grid) const {
  const double height = titleHeight(needs_);
  return {0, rowTop(grid, 0) - height, width_, height};
}

QRectF RuleGridGeometry::rowHead(std::size_t grid, std::size_t row) const {
  return {0, rowTop(grid, row), needs_.row_head - theme::kGrid, cell_height_ - kGap};
}

std::optional<RuleCell> RuleGridGeometry::at(QPointF place) const {
  for (std::size_t g = 0; g < needs_.rows.size(); ++g) {
    for (std::size_t r = 0; r < needs_.rows[g]; ++r) {
      const RuleCell first{g, r, 0};
      const double top = cell(first).top();
      if (place.y() < top || place.y() >= top + cell_height_) continue;
      const double column = (place.x() - needs_.row_head) / cell_width_;
      if (column < 0 || column >= static_cast<double>(needs_.columns)) return std::nullopt;
      return RuleCell{g, r, static_cast<std::size_t>(column)};
    }
  }
  return std::nullopt;
}

}  // namespace tactus::workbench
