// Where everything lies in the view of the grids: the names of the rows, then blocks of equal shape side by side. The
// first block stands still; the others scroll below it.
#pragma once

#include <QPoint>
#include <QRectF>
#include <QSize>
#include <cstddef>
#include <optional>
#include <vector>

#include "app/workbench/labs/rules/rules_lab.h"

namespace tactus::workbench {

class GridPlaces {
 public:
  static constexpr int kNarrowest = 26;  ///< px of a cell: two small letters and a frame
  /// `rows`, `columns`: of each block. `blocks`: besides the one that stands still. `breaks`: rows before which a gap
  /// parts the inputs. `names_px`: width of the names of the rows; `heads_px`: height of the heads of the columns.
  /// `room_px`: what the cells fill, as far as it keeps them readable.
  GridPlaces(std::size_t rows, std::size_t columns, std::size_t blocks, std::vector<std::size_t> breaks, int names_px,
             int heads_px, const QSize& room_px, int narrowest_px = kNarrowest);
  GridPlaces() = default;

  int width() const;
  int height() const;
  /// The height with the lowest cells.
  int leastHeight() const;
  /// Where the blocks that scroll begin.
  int scrollEdge() const { return blockLeft(0) + blockWidth() + kBlockGap; }

  /// Block 0 stands still; `scrolled_px` moves the others to the left.
  QRectF cell(std::size_t block, const GridPlace& place, int scrolled_px) const;
  QRectF columnHead(std::size_t block, std::size_t column, int scrolled_px) const;
  QRectF blockHead(std::size_t block, int scrolled_px) const;
  QRectF rowName(std::size_t row) const;

  struct Hit {
    std::size_t block = 0;
    GridPlace place;
  };
  std::optional<Hit> hit(const QPoint& point, int scrolled_px) const;

  static constexpr int kBlockHead = 24;
  static constexpr int kBlockGap = 16;

 private:
  int blockWidth() const { return static_cast<int>(columns_) * cell_width_; }
  int blockLeft(std::size_t block) const { return names_px_ + static_cast<int>(block) * (blockWidth() + kBlockGap); }
  int rowTop(std::size_t row) const;

  std::size_t rows_ = 0;
  std::size_t columns_ = 0;
  std::size_t blocks_ = 0;
  std::vector<std::size_t> breaks_;
  int names_px_ = 0;
  int heads_px_ = 0;
  int cell_width_ = 40;
  int cell_height_ = 26;
};

}  // namespace tactus::workbench
