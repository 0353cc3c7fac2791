#include "app/workbench/understand/map/contour_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace tactus::workbench {
namespace {

// A cell of the grid: forces at its corners, around the cell, so that neighbors in the list share an edge.
struct Cell {
  std::array<QPointF, 4> places;
  std::array<double, 4> force_n{};
};

void addPieces(const Cell& cell, double level_n, std::vector<QLineF>& lines) {
  std::array<QPointF, 4> points;
  std::size_t count = 0;
  double middle = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    const double here = cell.force_n[i] - level_n;
    const double there = cell.force_n[next] - level_n;
    middle += here / 4;
    if ((here > 0) == (there > 0)) continue;
    points[count++] = cell.places[i] + (cell.places[next] - cell.places[i]) * (here / (here - there));
  }
  if (count == 2) {
    lines.emplace_back(points[0], points[1]);
  } else if (count == 4) {
    // The edges are crossed in order; corner 0 stands alone where it differs from the middle.
    const bool first_alone = (cell.force_n[0] - level_n > 0) != (middle > 0);
    lines.emplace_back(points[0], points[first_alone ? 3 : 1]);
    lines.emplace_back(points[2], points[first_alone ? 1 : 3]);
  }
}

}  // namespace

std::vector<std::vector<QLineF>> contourLines(const ForceMap& map, std::span<const double> levels_n) {
  std::vector<std::vector<QLineF>> lines(levels_n.size());
  const std::size_t side = map.side;
  for (std::size_t y = 0; y + 1 < side; ++y) {
    const double* const below = map.force_n.data() + y * side;
    const double* const above = below + side;
    for (std::size_t x = 0; x + 1 < side; ++x) {
      // Most cells lie between two levels.
      const auto [low, high] = std::minmax({below[x], below[x + 1], above[x + 1], above[x]});
      auto level = std::lower_bound(levels_n.begin(), levels_n.end(), low);
      if (level == levels_n.end() || *level >= high) continue;
      if (!map.isFired(x, y) || !map.isFired(x + 1, y) || !map.isFired(x + 1, y + 1) || !map.isFired(x, y + 1)) {
        continue;
      }
      const auto left = static_cast<double>(x);
      const auto bottom = static_cast<double>(y);
      const Cell cell{{QPointF(left, bottom), {left + 1, bottom}, {left + 1, bottom + 1}, {left, bottom + 1}},
                      {below[x], below[x + 1], above[x + 1], above[x]}};
      for (; level != levels_n.end() && *level < high; ++level) {
        addPieces(cell, *level, lines[static_cast<std::size_t>(level - levels_n.begin())]);
      }
    }
  }
  return lines;
}

std::vector<QLineF> contourLines(const ForceMap& map, double level_n) {
  return std::move(contourLines(map, std::span(&level_n, 1)).front());
}

std::vector<double> contourLevels(double min_n, double max_n) {
  const double rough = (max_n - min_n) / 10;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  double step = power;
  for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
    step = factor * power;
    if (step >= rough * 0.8) break;
  }
  std::vector<double> levels;
  const auto first = static_cast<long long>(std::floor(min_n / step)) + 1;
  for (long long i = first; static_cast<double>(i) * step < max_n - step * 1e-9; ++i) {
    levels.push_back(static_cast<double>(i) * step);
  }
  return levels;
}

}  // namespace tactus::workbench
