#include "app/workbench/labs/rules/grid_places.h"

#include <algorithm>

namespace tactus::workbench {
namespace {

constexpr int kWidest = 78;  // px
constexpr int kLowest = 26;
constexpr int kHighest = 40;
constexpr int kRowGap = 8;

}  // namespace

GridPlaces::GridPlaces(std::size_t rows, std::size_t columns, std::size_t blocks, std::vector<std::size_t> breaks,
                       int names_px, int heads_px, const QSize& room_px, int narrowest_px)
    : rows_(rows),
      columns_(columns),
      blocks_(blocks),
      breaks_(std::move(breaks)),
      names_px_(names_px),
      heads_px_(heads_px),
      cell_height_(kLowest) {
  const int count = static_cast<int>(blocks_) + 1;
  const int room = room_px.width() - names_px_ - count * kBlockGap;
  if (columns_ > 0) cell_width_ = std::clamp(room / (count * static_cast<int>(columns_)), narrowest_px, kWidest);
  if (rows_ > 0) {
    cell_height_ = std::clamp(kLowest + (room_px.height() - height()) / static_cast<int>(rows_), kLowest, kHighest);
  }
}

int GridPlaces::leastHeight() const { return height() - static_cast<int>(rows_) * (cell_height_ - kLowest); }

int GridPlaces::width() const { return blockLeft(blocks_) + blockWidth(); }
int GridPlaces::height() const { return rows_ == 0 ? 0 : rowTop(rows_ - 1) + cell_height_; }

int GridPlaces::rowTop(std::size_t row) const {
  const auto gaps = std::count_if(breaks_.begin(), breaks_.end(), [row](std::size_t one) { return one <= row; });
  return kBlockHead + heads_px_ + static_cast<int>(row) * cell_height_ + static_cast<int>(gaps) * kRowGap;
}

QRectF GridPlaces::cell(std::size_t block, const GridPlace& place, int scrolled_px) const {
  const int left = blockLeft(block) - (block == 0 ? 0 : scrolled_px);
  return QRectF(left + static_cast<int>(place.column) * cell_width_, rowTop(place.row), cell_width_, cell_height_);
}

QRectF GridPlaces::columnHead(std::size_t block, std::size_t column, int scrolled_px) const {
  QRectF place = cell(block, {0, column}, scrolled_px);
  place.setTop(kBlockHead);
  place.setHeight(heads_px_);
  return place;
}

QRectF GridPlaces::blockHead(std::size_t block, int scrolled_px) const {
  const QRectF first = cell(block, {0, 0}, scrolled_px);
  return QRectF(first.left(), 0, blockWidth(), kBlockHead);
}

QRectF GridPlaces::rowName(std::size_t row) const { return QRectF(0, rowTop(row), names_px_, cell_height_); }

std::optional<GridPlaces::Hit> GridPlaces::hit(const QPoint& point, int scrolled_px) const {
  const bool scrolls = point.x() >= scrollEdge();
  const std::size_t first = scrolls ? 1 : 0;
  const std::size_t last = scrolls ? blocks_ : 0;
  for (std::size_t block = first; block <= last; ++block) {
    for (std::size_t row = 0; row < rows_; ++row) {
      for (std::size_t column = 0; column < columns_; ++column) {
        if (cell(block, {row, column}, scrolled_px).contains(point)) return Hit{block, {row, column}};
      }
    }
  }
  return std::nullopt;
}

}  // namespace tactus::workbench
