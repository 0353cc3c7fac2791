#include "app/workbench/understand/map/force_colors.h"

#include <algorithm>
#include <cmath>

#include "app/workbench/base/theme.h"

namespace tactus::workbench {

QColor forceColor(double share) {
  // Terms so many that two neighbors look the same.
  constexpr std::size_t kTerms = 256;
  return theme::force(static_cast<std::size_t>(std::lround(std::clamp(share, 0.0, 1.0) * (kTerms - 1))), kTerms);
}

QBrush silentGround() { return {theme::border(), Qt::BDiagPattern}; }

}  // namespace tactus::workbench
