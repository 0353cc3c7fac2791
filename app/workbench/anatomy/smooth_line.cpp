#include "app/workbench/anatomy/smooth_line.h"

#include <algorithm>

#include "core/base/check.h"

namespace tactus::workbench::anatomy {

std::vector<QPointF> smoothLine(const std::vector<QPointF>& through, std::size_t steps) {
  TACTUS_CHECK(through.size() >= 2 && steps > 0);
  const std::size_t last = through.size() - 1;
  std::vector<QPointF> line;
  line.reserve(last * steps + 1);
  for (std::size_t i = 0; i < last; ++i) {
    const QPointF from = through[i];
    const QPointF to = through[i + 1];
    const QPointF leaving = from + (to - through[i == 0 ? 0 : i - 1]) / 6;
    const QPointF arriving = to - (through[std::min(i + 2, last)] - from) / 6;
    for (std::size_t step = 0; step < steps; ++step) {
      const double t = static_cast<double>(step) / static_cast<double>(steps);
      const double s = 1 - t;
      line.push_back(from * (s * s * s) + leaving * (3 * s * s * t) + arriving * (3 * s * t * t) + to * (t * t * t));
    }
  }
  line.push_back(through.back());
  return line;
}

}  // namespace tactus::workbench::anatomy
