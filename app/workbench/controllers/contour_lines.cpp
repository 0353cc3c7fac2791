#include "app/workbench/controllers/contour_lines.h"

#include <array>
#include <cmath>

namespace tactus::workbench {
namespace {

struct Corner {
  double x = 0;
  double y = 0;
  double above = 0;  ///< force minus level
};

QPointF crossing(const Corner& a, const Corner& b) {
  const double share = a.above / (a.above - b.above);
  return {a.x + (b.x - a.x) * share, a.y + (b.y - a.y) * share};
}

}  // namespace

std::vector<QLineF> contourLines(const ForceMap& map, double level_n) {
  std::vector<QLineF> lines;
  for (std::size_t y = 0; y + 1 < map.side; ++y) {
    for (std::size_t x = 0; x + 1 < map.side; ++x) {
      // Around the cell, so that neighbors in the list share an edge.
      const std::array<std::array<std::size_t, 2>, 4> places = {{{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}};
      std::array<Corner, 4> corners;
      bool fired = true;
      double mean = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        const auto [cx, cy] = places[i];
        fired = fired && map.isFired(cx, cy);
        corners[i] = {static_cast<double>(cx), static_cast<double>(cy), map.force(cx, cy) - level_n};
        mean += corners[i].above / 4;
      }
      if (!fired) continue;
      std::array<QPointF, 4> points;
      std::size_t count = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        const Corner& next = corners[(i + 1) % 4];
        if ((corners[i].above > 0) != (next.above > 0)) points[count++] = crossing(corners[i], next);
      }
      if (count == 2) {
        lines.emplace_back(points[0], points[1]);
      } else if (count == 4) {
        // The edges are crossed in order; corner 0 stands alone where it differs from the middle.
        const bool first_alone = (corners[0].above > 0) != (mean > 0);
        lines.emplace_back(points[0], points[first_alone ? 3 : 1]);
        lines.emplace_back(points[2], points[first_alone ? 1 : 3]);
      }
    }
  }
  return lines;
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
