// The positions of the cells of the rule grids. The grids stand one above the other, below common column heads.
#pragma once

#include <QRectF>
#include <QSize>
#include <optional>
#include <vector>

#include "app/workbench/tune/rules/rule_controller.h"

namespace tactus::workbench {

class RuleGridGeometry {
 public:
  struct Needs {
    std::vector<std::size_t> rows;  ///< per grid
    std::size_t columns = 0;
    double row_head = 0;  ///< px, width of the row heads
    double line = 0;      ///< px, height of a line of text
    double cell = 0;      ///< px, width for the longest word
  };

  RuleGridGeometry() = default;
  RuleGridGeometry(Needs needs, QSizeF room);

  /// The size below which the grids need scroll bars.
  static QSizeF smallest(const Needs& needs);

  QRectF cell(const RuleCell& cell) const;
  QRectF columnHead(std::size_t column) const;
  QRectF corner() const;
  QRectF title(std::size_t grid) const;
  QRectF rowHead(std::size_t grid, std::size_t row) const;
  std::optional<RuleCell> at(QPointF place) const;

 private:
  double rowTop(std::size_t grid, std::size_t row) const;

  Needs needs_;
  double width_ = 0;
  double cell_width_ = 0;
  double cell_height_ = 0;
};

}  // namespace tactus::workbench
